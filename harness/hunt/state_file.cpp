#include "harness/hunt/state_file.h"

#include <cmath>
#include <string_view>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

namespace {

// A line "WORD a b .." of numbers, then one line "x y" per point.
void append(std::string& text, std::string_view word, const std::vector<double>& numbers,
            const std::vector<Point>& points) {
  text += word;
  for (const double number : numbers) (text += ' ') += number_text(number);
  text += '\n';
  for (const Point& p : points) text += number_text(p.x) + ' ' + number_text(p.y) + '\n';
}

class StateReader {
 public:
  StateReader(const std::string& path, std::string_view text) : lines_(path, text) {}

  std::vector<ClimberState> read(const std::string& identity) {
    if (!lines_.next() || lines_.line() != identity) {
      lines_.fail("state of another hunt; give another output file, or the options with which this one began: " +
                  std::string(lines_.line()));
    }
    std::vector<ClimberState> climbers;
    for (std::uint64_t left = count_of(numbers("climbers", 1)[0]); left > 0; --left) {
      const std::vector<double> steps = numbers("climber", 2);
      ClimberState& climber = climbers.emplace_back();
      climber.evaluations = count_of(steps[0]);
      climber.last_progress = count_of(steps[1]);
      climber.current = rated_instance("current");
      climber.best = rated_instance("best");
    }
    (void)numbers("end", 0);
    return climbers;
  }

 private:
  RatedInstance rated_instance(std::string_view word) {
    const std::vector<double> head = numbers(word, 2);
    RatedInstance instance;
    instance.alpha = head[0];
    for (std::uint64_t left = count_of(head[1]); left > 0; --left) {
      const std::vector<double> coordinates = numbers("", 2);
      instance.points.push_back({coordinates[0], coordinates[1]});
    }
    return instance;
  }

  // The numbers of the next line, which begins with `word`.
  std::vector<double> numbers(std::string_view word, std::size_t count) {
    if (!lines_.next()) lines_.fail_as_a_whole("ends too early; delete it to begin anew");
    std::vector<std::string_view> columns;
    split_columns(lines_.line(), ' ', columns);
    if (!word.empty() && !columns.empty() && columns[0] == word) columns.erase(columns.begin());
    std::vector<double> values;
    for (const std::string_view column : columns) {
      const std::optional<double> value = parse_number(column);
      if (value && std::isfinite(*value)) values.push_back(*value);
    }
    if (values.size() != columns.size() || values.size() != count) refuse();
    return values;
  }

  // Whole, and exact as a double.
  std::uint64_t count_of(double number) const {
    if (!(number >= 0 && number <= 0x1p53) || std::floor(number) != number) refuse();
    return static_cast<std::uint64_t>(number);
  }

  [[noreturn]] void refuse() const { lines_.fail("not the state of a hunt; delete the file to begin anew"); }

  TextLines lines_;
};

}  // namespace

void write_hunt_state(const std::string& path, const std::string& identity, const std::vector<ClimberState>& climbers) {
  std::string text = identity + '\n';
  append(text, "climbers", {static_cast<double>(climbers.size())}, {});
  for (const ClimberState& climber : climbers) {
    append(text, "climber", {static_cast<double>(climber.evaluations), static_cast<double>(climber.last_progress)}, {});
    for (const auto& [word, instance] : {std::pair("current", &climber.current), std::pair("best", &climber.best)}) {
      append(text, word, {instance->alpha, static_cast<double>(instance->points.size())}, instance->points);
    }
  }
  write_file_atomically(path, text + "end\n");
}

std::vector<ClimberState> read_hunt_state(const std::string& path, const std::string& identity) {
  return StateReader(path, read_file(path)).read(identity);
}

}  // namespace mwt

#include "harness/run/callgrind/profile.h"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "base/number_text.h"
#include "harness/io/text/csv.h"
#include "harness/io/text/text.h"

namespace mwt {

namespace {

constexpr const char* kOthers = "(other functions)";

/// Reads a callgrind.out file line by line: valgrind's manual, "Callgrind Format Specification".
class CallgrindReader {
 public:
  CallgrindProfile read(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) take(line);
    if (events_.empty() || sums_.empty() || sum_of("Ir") == 0)
      throw std::invalid_argument("callgrind counted no instructions");
    profile_.counts = {sum_of("Ir"), sum_of("I1mr") + sum_of("D1mr") + sum_of("D1mw"),
                       sum_of("ILmr") + sum_of("DLmr") + sum_of("DLmw"), sum_of("Bcm") + sum_of("Bim")};
    return std::move(profile_);
  }

 private:
  void take(const std::string& line) {
    if (line.starts_with("events: ")) {
      events_ = split(line.substr(8), ' ');
      sums_.assign(events_.size(), 0);
    } else if (line.starts_with("fn=")) {
      function_ = without_recursion(full_name(line.substr(3)));
    } else if (line.starts_with("calls=")) {
      is_call_ = true;  // the costs in the next line are those of the called function
    } else if (!line.empty() && (std::isdigit(static_cast<unsigned char>(line[0])) != 0 || line[0] == '+' ||
                                 line[0] == '-' || line[0] == '*')) {
      if (!is_call_) add_costs(line);
      is_call_ = false;
    } else if (line.starts_with("cfn=")) {
      static_cast<void>(full_name(line.substr(4)));  // may be the first mention of a number
    }
  }

  /// "(12) name" gives the number 12 a name, "(12)" stands for it.
  std::string full_name(const std::string& text) {
    const std::size_t end = text.find(')');
    if (!text.starts_with("(") || end == std::string::npos) return text;
    std::string& name = names_[text.substr(1, end - 1)];
    if (end + 2 < text.size()) name = text.substr(end + 2);
    return name;
  }

  /// "name'2" is the second level of a recursion.
  static std::string without_recursion(const std::string& name) {
    const std::size_t mark = name.rfind('\'');
    const bool is_level = mark != std::string::npos && mark + 1 < name.size() &&
                          name.find_first_not_of("0123456789", mark + 1) == std::string::npos;
    return is_level ? name.substr(0, mark) : name;
  }

  /// A position, then the costs; missing ones at the end are 0.
  void add_costs(const std::string& line) {
    const std::vector<std::string> fields = split(line, ' ');
    for (std::size_t i = 1; i < fields.size() && i <= sums_.size(); ++i) {
      const std::optional<std::uint64_t> cost = parse_whole_number<std::uint64_t>(fields[i]);
      if (!cost) throw std::invalid_argument(line);
      sums_[i - 1] += *cost;
      if (events_[i - 1] == "Ir") profile_.functions[function_] += *cost;
    }
  }

  [[nodiscard]] std::uint64_t sum_of(const std::string& event) const {
    const auto found = std::ranges::find(events_, event);
    return found == events_.end() ? 0 : sums_[static_cast<std::size_t>(found - events_.begin())];
  }

  CallgrindProfile profile_;
  std::vector<std::string> events_;
  std::vector<std::uint64_t> sums_;
  std::map<std::string, std::string> names_;
  std::string function_;
  bool is_call_ = false;
};

std::uint64_t sum_of_all(const FunctionCounts& functions) {
  return std::accumulate(functions.begin(), functions.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const auto& entry) { return sum + entry.second; });
}

void erase_all(std::string& text, const std::string& part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part)) text.erase(at, part.size());
}

/// Without what stands in these brackets, and without them.
std::string without_brackets(const std::string& text, char open, char close) {
  std::string result;
  int depth = 0;
  for (const char c : text) {
    if (c == open) ++depth;
    if (depth == 0) result += c;
    if (c == close && depth > 0) --depth;
  }
  return result;
}

}  // namespace

CallgrindProfile parse_callgrind(const std::string& text) { return CallgrindReader().read(text); }

std::string short_function_name(const std::string& name) {
  if (name.find("operator") != std::string::npos) return name;  // brackets are parts of such names
  std::string text = name;
  erase_all(text, "(anonymous namespace)::");
  text = without_brackets(text, '<', '>');
  text = without_brackets(text, '(', ')');
  for (const char* end : {" const", " [clone .isra.0]", " [clone .constprop.0]"}) {
    if (text.ends_with(end)) text.erase(text.size() - std::string(end).size());
  }
  const std::size_t blank = text.rfind(' ');  // after the type that a template returns
  if (blank != std::string::npos && text.find('[') == std::string::npos) text.erase(0, blank + 1);
  erase_all(text, "mwt::");
  return text.empty() ? name : text;
}

std::string ChangedFunction::text() const {
  if (before == 0) return name + " (new)";
  if (after == 0) return name + " (gone)";
  const double change = 100 * (static_cast<double>(after) / static_cast<double>(before) - 1);
  return fmt::format("{} {}{}%", name, change >= 0 ? "+" : "", fixed(change, 1));
}

std::optional<ChangedFunction> most_changed(const FunctionCounts& before, const FunctionCounts& after) {
  if (before.empty() || after.empty()) return std::nullopt;
  FunctionCounts all = before;
  for (const auto& [name, count] : after) all.try_emplace(name, 0);
  const auto count_in = [](const FunctionCounts& functions, const std::string& name) {
    const auto found = functions.find(name);
    return found == functions.end() ? std::uint64_t{0} : found->second;
  };
  const double sign = sum_of_all(after) >= sum_of_all(before) ? 1 : -1;
  std::optional<ChangedFunction> most;
  double largest = 0;
  for (const auto& [name, ignored] : all) {
    const std::uint64_t a = count_in(before, name), b = count_in(after, name);
    const double change = sign * (static_cast<double>(b) - static_cast<double>(a));
    if (change <= largest) continue;
    largest = change;
    most = ChangedFunction{short_function_name(name), a, b};
  }
  return most;
}

std::string to_csv(const FunctionCounts& functions) {
  std::vector<std::pair<std::string, std::uint64_t>> rows(functions.begin(), functions.end());
  std::ranges::stable_sort(rows, [](const auto& a, const auto& b) { return a.second > b.second; });
  const std::uint64_t least = sum_of_all(functions) / 1000;
  std::uint64_t others = 0;
  std::string text = csv_line({"function", "instructions"});
  for (const auto& [name, count] : rows) {
    if (count > least) {
      text += csv_line({name, std::to_string(count)});
    } else {
      others += count;
    }
  }
  return text + csv_line({kOthers, std::to_string(others)});
}

FunctionCounts functions_of_csv(const std::string& text) {
  FunctionCounts functions;
  const std::vector<CsvRow> rows = parse_csv(text);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const auto count = rows[i].size() == 2 ? parse_whole_number<std::uint64_t>(rows[i][1]) : std::nullopt;
    if (!count) throw std::invalid_argument(fmt::format("row {} is no function with its instructions", i + 1));
    functions[rows[i][0]] += *count;
  }
  return functions;
}

}  // namespace mwt

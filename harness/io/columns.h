// Values as rows of text: the columns of a table, each of which prints one member of a value and reads it again.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/number_text.h"
#include "harness/io/text/csv.h"
#include "harness/io/text/text.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

template <class Record>
struct Column {
  std::string name;
  std::function<std::string(const Record&)> text_of;
  std::function<void(Record&, const std::string&)> read;  ///< throws std::invalid_argument on malformed text, NaN
                                                          ///< and times that are none
};

// Members of other types bring their own to_text() and read_text(), found beside the type.
inline std::string to_text(const std::string& value) { return one_line(value); }
inline std::string to_text(double value) { return number_text(value); }
inline std::string to_text(bool value) { return value ? "1" : "0"; }
inline std::string to_text(int value) { return std::to_string(value); }
inline std::string to_text(std::uint32_t value) { return std::to_string(value); }
inline std::string to_text(std::uint64_t value) { return std::to_string(value); }

template <class Whole>
requires std::is_integral_v<Whole>
void read_text(const std::string& text, Whole& value) {
  const std::optional<Whole> number = parse_whole_number<Whole>(text);
  if (!number) throw std::invalid_argument(text);
  value = *number;
}
// No measure is infinite or not a number: such a field is damaged.
inline void read_text(const std::string& text, double& value) {
  const std::optional<double> number = parse_number(text);
  if (!number || !std::isfinite(*number)) throw std::invalid_argument(text);
  value = *number;
}
inline void read_text(const std::string& text, std::string& value) { value = text; }
inline void read_text(const std::string& text, bool& value) {
  if (text != "0" && text != "1") throw std::invalid_argument(text);
  value = text == "1";
}

/// A missing value is an empty field.
template <class Value>
std::string to_text(const std::optional<Value>& value) {
  return value ? to_text(*value) : "";
}
template <class Value>
void read_text(const std::string& text, std::optional<Value>& value) {
  value.reset();
  if (!text.empty()) read_text(text, value.emplace());
}

/// The column of one member.
template <class Record, class Base, class Value>
[[nodiscard]] Column<Record> column(std::string name, Value Base::*member) {
  return {std::move(name), [member](const Record& record) { return to_text(record.*member); },
          [member](Record& record, const std::string& text) { read_text(text, record.*member); }};
}

/// The column of a member in seconds: no negative number is one.
template <class Record, class Base, class Seconds>
[[nodiscard]] Column<Record> time_column(std::string name, Seconds Base::*member) {
  Column<Record> result = column<Record>(std::move(name), member);
  result.read = [member, read = result.read](Record& record, const std::string& text) {
    read(record, text);
    if (std::optional<double>(record.*member).value_or(0) < 0) throw std::invalid_argument(text);
  };
  return result;
}

template <class Record>
[[nodiscard]] CsvRow header_of(const std::vector<Column<Record>>& columns) {
  CsvRow row;
  for (const Column<Record>& column : columns) row.push_back(column.name);
  return row;
}

template <class Record>
[[nodiscard]] CsvRow to_row(const std::vector<Column<Record>>& columns, const Record& record) {
  CsvRow row;
  for (const Column<Record>& column : columns) row.push_back(column.text_of(record));
  return row;
}

/// The value of a row. Throws std::invalid_argument "'nan' is no wall_time_s" if the row has a malformed field or
/// another number of fields than columns.
template <class Record>
[[nodiscard]] Record read_row(const std::vector<Column<Record>>& columns, const CsvRow& row) {
  if (row.size() != columns.size()) {
    throw std::invalid_argument(std::to_string(row.size()) + " fields where there should be " +
                                std::to_string(columns.size()));
  }
  Record record;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    try {
      columns[i].read(record, row[i]);
    } catch (const std::invalid_argument&) {
      throw std::invalid_argument(shown(row[i]) + " is no " + columns[i].name);
    }
  }
  return record;
}

}  // namespace mwt

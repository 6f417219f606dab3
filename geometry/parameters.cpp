#include "geometry/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "geometry/error.h"
#include "geometry/utf8.h"

namespace mwt {

namespace {

template <class Number>
bool parses_as(const std::string& text, Number& value) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

bool is_finite_real(const std::string& text) {
  double value = 0;
  return parses_as(text, value) && std::isfinite(value);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void require_valid(const std::string& owner, const ParameterInfo& info, const std::string& value) {
  const std::string place = owner + ": parameter " + info.name + "=" + value;
  std::int64_t integer = 0;
  if (info.type == ParameterType::integer && !parses_as(value, integer)) {
    throw InputError(place + " is not an integer");
  }
  if (info.type == ParameterType::real && !is_finite_real(value)) throw InputError(place + " is not a number");
  const bool offered = std::find(info.choices.begin(), info.choices.end(), value) != info.choices.end();
  if (info.type == ParameterType::choice && !offered) {
    throw InputError(place + " is not one of " + joined(info.choices));
  }
}

}  // namespace

Parameters::Parameters(const std::string& owner, const std::vector<ParameterInfo>& declared,
                       const std::map<std::string, std::string>& given)
    : owner_(owner) {
  std::vector<std::string> names;
  for (const ParameterInfo& info : declared) {
    values_[info.name] = info.default_value;
    names.push_back(info.name);
  }
  for (const auto& [name, value] : given) {
    const auto info = std::find_if(declared.begin(), declared.end(), [&](const auto& i) { return i.name == name; });
    if (info == declared.end()) {
      throw InputError(owner + ": unknown parameter '" + name + "'; " +
                       (names.empty() ? "it has none" : "it has " + joined(names)));
    }
    require_valid(owner, *info, value);
    values_[name] = value;
  }
}

std::int64_t Parameters::integer(const std::string& name) const {
  std::int64_t value = 0;
  if (!parses_as(value_of(name), value)) throw InputError("parameter " + name + " is not an integer");
  return value;
}

double Parameters::real(const std::string& name) const {
  double value = 0;
  if (!parses_as(value_of(name), value)) throw InputError("parameter " + name + " is not a number");
  return value;
}

const std::string& Parameters::text(const std::string& name) const { return value_of(name); }

const std::string& Parameters::value_of(const std::string& name) const {
  const auto entry = values_.find(name);
  if (entry != values_.end()) return entry->second;
  std::vector<std::string> declared;
  for (const auto& [known, value] : values_) declared.push_back(known);
  throw std::out_of_range("the code of '" + owner_ + "' reads a parameter '" + name +
                          "' that its entry does not declare; it declares " +
                          (declared.empty() ? "none" : joined(declared)));
}

std::string Parameters::canonical() const {
  std::string text;
  for (const auto& [name, value] : values_) {
    if (!text.empty()) text += ' ';
    text += canonical_parameter(name, value);
  }
  return text;
}

namespace {

void append_escaped(std::string& text, char c) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  const auto byte = static_cast<unsigned char>(c);
  text += '%';
  text += kDigits[byte >> 4];
  text += kDigits[byte & 15];
}

std::string unescaped(std::string_view text) {
  std::string value;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned byte = 0;
    const char* const digits = text.data() + i + 1;
    const bool is_escape =
        text[i] == '%' && i + 2 < text.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    value += is_escape ? static_cast<char>(byte) : text[i];
    if (is_escape) i += 2;
  }
  return value;
}

}  // namespace

std::string canonical_parameter(const std::string& name, const std::string& value) {
  std::string text = name + '=';
  for (std::size_t i = 0; i < value.size();) {
    const std::size_t length = utf8_length(value, i);
    const bool is_special = static_cast<unsigned char>(value[i]) <= ' ' || value[i] == '\x7f' || value[i] == '%';
    if (length == 0 || is_special) {
      append_escaped(text, value[i++]);
    } else {
      text.append(value, i, length);
      i += length;
    }
  }
  return text;
}

std::map<std::string, std::string> parse_canonical(std::string_view text) {
  std::map<std::string, std::string> values;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view parameter = text.substr(0, end);
    const std::size_t equals = parameter.find('=');
    if (equals != std::string_view::npos) {
      values[std::string(parameter.substr(0, equals))] = unescaped(parameter.substr(equals + 1));
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return values;
}

}  // namespace mwt

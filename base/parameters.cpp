#include "base/parameters.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <stdexcept>

#include "base/error.h"
#include "base/given_number.h"
#include "base/number_text.h"
#include "base/unicode.h"

namespace mwt {

namespace {

constexpr NumberRange<std::int64_t> kIntegers{std::numeric_limits<std::int64_t>::min(),
                                              std::numeric_limits<std::int64_t>::max()};
constexpr NumberRange<double> kReals{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

// Numbers that mean the same are the same text: "08" is "8".
std::string normalised(const ParameterInfo& info, const std::string& place, const std::string& value) {
  switch (info.type) {
    case ParameterType::integer: return std::to_string(given_number(place, value, kIntegers));
    case ParameterType::real: return number_text(given_number(place, value, kReals));
    case ParameterType::text:
    case ParameterType::choice: return value;
  }
  return value;
}

std::string valid_value(const std::string& owner, const ParameterInfo& info, const std::string& value) {
  const std::string place = fmt::format("{}: parameter {}={}", owner, info.name, value);
  const bool offered = std::find(info.choices.begin(), info.choices.end(), value) != info.choices.end();
  if (info.type == ParameterType::choice && !offered) {
    throw InputError(place + " is not one of " + joined(info.choices));
  }
  const std::string text = normalised(info, place, value);
  const bool is_default = text == normalised(info, place, info.default_value);
  return is_default ? info.default_value : text;
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
    const auto info =
        std::find_if(declared.begin(), declared.end(), [&name = name](const auto& i) { return i.name == name; });
    if (info == declared.end()) {
      throw InputError(fmt::format("{}: unknown parameter '{}'; {}", owner, name,
                                   names.empty() ? "it has none" : "it has " + joined(names)));
    }
    values_[name] = valid_value(owner, *info, value);
  }
}

std::int64_t Parameters::integer(const std::string& name) const {
  return given_number("parameter " + name + "=" + value_of(name), value_of(name), kIntegers);
}

double Parameters::real(const std::string& name) const {
  return given_number("parameter " + name + "=" + value_of(name), value_of(name), kReals);
}

const std::string& Parameters::text(const std::string& name) const { return value_of(name); }

const std::string& Parameters::value_of(const std::string& name) const {
  const auto entry = values_.find(name);
  if (entry != values_.end()) return entry->second;
  std::vector<std::string> declared;
  for (const auto& [known, value] : values_) declared.push_back(known);
  throw std::out_of_range(
      fmt::format("the code of '{}' reads a parameter '{}' that its entry does not declare; it declares {}", owner_,
                  name, declared.empty() ? "none" : joined(declared)));
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

std::string escaped(char c) { return fmt::format("%{:02X}", static_cast<unsigned char>(c)); }

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
    const std::optional<Character> character = first_character(std::string_view(value).substr(i));
    const bool is_special = static_cast<unsigned char>(value[i]) <= ' ' || value[i] == '\x7f' || value[i] == '%';
    if (!character || is_special) {
      text += escaped(value[i++]);
    } else {
      text.append(value, i, character->size);
      i += character->size;
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

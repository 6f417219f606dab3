#include "geometry/parameters.h"

#include <algorithm>
#include <limits>

#include "geometry/error.h"
#include "geometry/given_number.h"
#include "geometry/number_text.h"

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
  const std::string place = owner + ": parameter " + info.name + "=" + value;
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
                       const std::map<std::string, std::string>& given) {
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
    values_[name] = valid_value(owner, *info, value);
  }
}

std::int64_t Parameters::integer(const std::string& name) const {
  return given_number("parameter " + name + "=" + values_.at(name), values_.at(name), kIntegers);
}

double Parameters::real(const std::string& name) const {
  return given_number("parameter " + name + "=" + values_.at(name), values_.at(name), kReals);
}

const std::string& Parameters::text(const std::string& name) const { return values_.at(name); }

std::string Parameters::canonical() const {
  std::string text;
  for (const auto& [name, value] : values_) text += (text.empty() ? "" : " ") + name + "=" + value;
  return text;
}

}  // namespace mwt

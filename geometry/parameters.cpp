#include "geometry/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "geometry/error.h"

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
    require_valid(owner, *info, value);
    values_[name] = value;
  }
}

std::int64_t Parameters::integer(const std::string& name) const {
  std::int64_t value = 0;
  if (!parses_as(values_.at(name), value)) throw InputError("parameter " + name + " is not an integer");
  return value;
}

double Parameters::real(const std::string& name) const {
  double value = 0;
  if (!parses_as(values_.at(name), value)) throw InputError("parameter " + name + " is not a number");
  return value;
}

const std::string& Parameters::text(const std::string& name) const { return values_.at(name); }

std::string Parameters::canonical() const {
  std::string text;
  for (const auto& [name, value] : values_) text += (text.empty() ? "" : " ") + name + "=" + value;
  return text;
}

}  // namespace mwt

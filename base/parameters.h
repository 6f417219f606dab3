// Named parameters with declared defaults, shared by the registries of algorithms and generators.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mwt {

enum class ParameterType { integer, real, text, choice };

/// A parameter as its registry entry declares it.
struct ParameterInfo {
  std::string name;
  ParameterType type = ParameterType::text;
  std::string default_value;
  std::string summary;                 ///< what it means, its unit and its range
  std::vector<std::string> choices{};  ///< the values of a `choice`; a hint for others
};

/// Values for all declared parameters of one run.
class Parameters {
 public:
  Parameters() = default;

  /// The declared defaults overridden by `given`; numbers in their shortest form, or as the default writes them if they
  /// equal it, so that "08" and "8" are the same configuration. Throws InputError naming `owner` for an unknown name, a
  /// value that is not of the declared type, or a choice that is not offered.
  Parameters(const std::string& owner, const std::vector<ParameterInfo>& declared,
             const std::map<std::string, std::string>& given);

  /// Values by name. Throws std::out_of_range for an undeclared name, which is a mistake in the owner's code.
  [[nodiscard]] std::int64_t integer(const std::string& name) const;
  [[nodiscard]] double real(const std::string& name) const;
  [[nodiscard]] const std::string& text(const std::string& name) const;

  [[nodiscard]] const std::map<std::string, std::string>& all() const { return values_; }

  /// "k=6 start=greedy": sorted by name, empty without parameters. Identifies a configuration in records; values are
  /// written as canonical_parameter() writes them.
  [[nodiscard]] std::string canonical() const;

 private:
  [[nodiscard]] const std::string& value_of(const std::string& name) const;

  std::string owner_;  // for messages
  std::map<std::string, std::string> values_;
};

/// "name=value" without blanks: in the value, blanks, control characters, '%' and bytes that are no UTF-8 are written
/// as in a URL, "my%20file.csv", so that blanks separate parameters and records stay text.
[[nodiscard]] std::string canonical_parameter(const std::string& name, const std::string& value);

/// The parameters of a canonical text, values as they were given.
[[nodiscard]] std::map<std::string, std::string> parse_canonical(std::string_view text);

}  // namespace mwt

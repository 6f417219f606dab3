// What a command answers: its triangles or edges, and the line in which it states more.
#pragma once

#include <string>
#include <string_view>

#include "algorithms/algorithm.h"

namespace mwt {

/// Where the triangles are.
enum class ReplyKind { triangles, edges };

/// The solution in a file of triangles or edges (harness/io/triangulation_file.h), whose corners are positions in
/// `points`, from 0. Throws CommandFailure with invalid_output: no file, or none of that kind.
[[nodiscard]] Triangulation read_reply(const std::string& file, ReplyKind kind, Points points);

/// Takes the last line off `output` if it begins with '{', and enters what it states: "time_s" (as the counter
/// stated_time_s), "lower_bound" (claimed_lower), "stopped_early" (true), "counters" (an object of numbers). Throws
/// CommandFailure with invalid_output if the line is no such object.
void take_statement(std::string& output, Solution& solution);

}  // namespace mwt

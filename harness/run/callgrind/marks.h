// Where valgrind's callgrind counts.
#pragma once

namespace mwt {

/// Callgrind, if the program runs under it with --instr-atstart=no, counts while one lives: a client request at either
/// end. Without valgrind these are a few instructions that do nothing.
class CallgrindMark {
 public:
  CallgrindMark();
  ~CallgrindMark();
  CallgrindMark(const CallgrindMark&) = delete;
  CallgrindMark& operator=(const CallgrindMark&) = delete;
};

}  // namespace mwt

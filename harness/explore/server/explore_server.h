// The HTTP server of mwt explore, on the loopback address only.
#pragma once

#include <memory>
#include <string>

#include "harness/explore/server/job_host.h"

namespace mwt {

struct ExploreOptions {
  int port = 0;              ///< 0: any that is free
  int parallel_jobs = 2;     ///< further ones wait
  int waiting_jobs = 16;     ///< further ones are refused
  std::string catalogue;     ///< JSON: what the page chooses from
  std::string given_points;  ///< an encoded frame: the points of the file that the user has named; empty: none
};

/// Serves the page's files, the catalogue and the given points to GET, and jobs to POST /TOKEN/job: the request's body
/// and the answer are frames (jobs.h). POST /TOKEN/keep takes the bytes of points and answers a name, by which GET
/// /TOKEN/kept/NAME gives them back (kept_points.h: 256 MiB in all).
///
/// Refuses, before reading a body: another Host or Origin, a path without the token (access.h): 403; bodies without a
/// length, encoded, not application/octet-stream, or longer than 64 MiB; jobs beyond parallel_jobs + waiting_jobs: 503.
/// A head must arrive within 3 s (arriving_requests.h), all of a request within 10 s more. Ends the job of a page that
/// has closed its connection.
class ExploreServer {
 public:
  /// Binds to the port. Throws InputError if it is taken. `host` must live longer.
  ExploreServer(const JobHost& host, ExploreOptions options);
  ~ExploreServer();
  ExploreServer(const ExploreServer&) = delete;
  ExploreServer& operator=(const ExploreServer&) = delete;

  /// "http://127.0.0.1:PORT/TOKEN/"
  [[nodiscard]] std::string address() const;

  /// Serves until stop() is called from another thread, once. stop() returns when no further connection is accepted.
  void serve();
  void stop();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mwt

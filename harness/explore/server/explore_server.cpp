#include "harness/explore/server/explore_server.h"

#include <fmt/core.h>
#include <poll.h>
#include <pthread.h>
#include <sys/socket.h>
#include <unistd.h>

// Debian compiles the library with these; its classes have other members without them.
#define CPPHTTPLIB_BROTLI_SUPPORT
#define CPPHTTPLIB_OPENSSL_SUPPORT
#define CPPHTTPLIB_ZLIB_SUPPORT
#include <httplib.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/explore/server/access.h"
#include "harness/explore/server/arriving_requests.h"
#include "harness/explore/server/connection_threads.h"
#include "harness/explore/server/kept_points.h"
#include "harness/explore/server/page_files.h"

namespace mwt {

namespace {

constexpr std::size_t kMaxBody = std::size_t{64} << 20;
constexpr std::size_t kMaxKept = std::size_t{256} << 20;
constexpr const char* kLoopback = "127.0.0.1";
constexpr const char* kBytes = "application/octet-stream";

using Clock = std::chrono::steady_clock;

// Whether one of the events has come before the time.
bool awaits(int socket, short events, Clock::time_point end) {
  pollfd watched{socket, events, 0};
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
  return poll(&watched, 1, static_cast<int>(std::max<std::int64_t>(0, left.count()))) > 0 &&
         (watched.revents & (POLLERR | POLLRDHUP | POLLHUP)) == 0;
}

// A connection as httplib reads and writes it. Unlike its own one, it gives a whole request, not each part of it, a
// time to arrive.
class ConnectionStream : public httplib::Stream {
 public:
  explicit ConnectionStream(int socket) : socket_(socket) {}

  [[nodiscard]] bool is_readable() const override { return begin_ < end_ || awaits(socket_, POLLIN, request_end_); }
  [[nodiscard]] bool is_writable() const override {
    return awaits(socket_, POLLOUT | POLLRDHUP, Clock::now() + kWritePatience);
  }

  ssize_t read(char* to, std::size_t size) override {
    if (begin_ == end_) {
      pollfd watched{socket_, POLLIN, 0};
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(request_end_ - Clock::now());
      if (left.count() <= 0 || poll(&watched, 1, static_cast<int>(left.count())) <= 0) return -1;
      const ssize_t received = recv(socket_, buffer_.data(), buffer_.size(), 0);
      if (received <= 0) return received;
      begin_ = 0;
      end_ = static_cast<std::size_t>(received);
    }
    const std::size_t part = std::min(size, end_ - begin_);
    std::copy_n(buffer_.data() + begin_, part, to);
    begin_ += part;
    return static_cast<ssize_t>(part);
  }

  ssize_t write(const char* from, std::size_t size) override {
    return is_writable() ? send(socket_, from, size, MSG_NOSIGNAL) : -1;
  }

  void get_remote_ip_and_port(std::string& ip, int& port) const override { get_local_ip_and_port(ip, port); }
  void get_local_ip_and_port(std::string& ip, int& port) const override {
    ip = kLoopback;
    port = 0;
  }
  [[nodiscard]] socket_t socket() const override { return socket_; }

 private:
  static constexpr std::chrono::seconds kRequestPatience{10};
  static constexpr std::chrono::seconds kWritePatience{5};

  int socket_;
  Clock::time_point request_end_ = Clock::now() + kRequestPatience;
  std::array<char, 1 << 16> buffer_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

// Hands over every connection that httplib has accepted.
class AcceptingServer : public httplib::Server {
 public:
  AcceptingServer() {
    new_task_queue = [] { return new Immediately; };
  }

  // Serves until stop() is called.
  void serve() {
    ConnectionThreads threads(32, 256, [this](int socket) { answer(socket); });
    ArrivingRequests arriving({}, [&threads](int socket) { threads.add(socket); });
    accepted_ = [&arriving](int socket) { arriving.add(socket); };
    if (!ends_) listen_after_bind();
    has_ended_ = true;
  }

  // Also if serve() is about to begin.
  void end() {
    ends_ = true;
    for (bool has_stopped = false; !has_ended_;) {
      if (!has_stopped && is_running()) {
        stop();  // not to be called twice
        has_stopped = true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

 private:
  class Immediately : public httplib::TaskQueue {
   public:
    void enqueue(std::function<void()> task) override { task(); }
    void shutdown() override {}
  };

  bool process_and_close_socket(socket_t socket) override {
    accepted_(socket);
    return true;
  }

  void answer(int socket) {
    ConnectionStream stream(socket);
    bool is_closed = false;
    process_request(stream, /*close_connection=*/true, is_closed, nullptr);
  }

  std::function<void(int socket)> accepted_;
  std::atomic<bool> ends_ = false;
  std::atomic<bool> has_ended_ = false;
};

// How many jobs there are and run.
class JobPlaces {
 public:
  JobPlaces(int parallel, int waiting) : parallel_(parallel), all_(parallel + waiting) {}

  bool enter() {
    const std::lock_guard lock(mutex_);
    if (present_ == all_) return false;
    ++present_;
    return true;
  }

  bool begin() {
    const std::lock_guard lock(mutex_);
    if (running_ == parallel_) return false;
    ++running_;
    return true;
  }

  void leave(bool was_running) {
    const std::lock_guard lock(mutex_);
    --present_;
    if (was_running) --running_;
  }

 private:
  std::mutex mutex_;
  int parallel_;
  int all_;
  int present_ = 0;
  int running_ = 0;
};

// One job, from its place among those that wait to the end of its answer.
class StreamedJob {
 public:
  StreamedJob(const JobHost& host, JobPlaces& places, std::string request)
      : host_(host), places_(places), request_(std::move(request)) {}
  ~StreamedJob() {
    if (answer_ >= 0) close(answer_);
    places_.leave(runs_);
  }
  StreamedJob(const StreamedJob&) = delete;
  StreamedJob& operator=(const StreamedJob&) = delete;

  // Passes on what there is. Returns whether the connection is to be kept; called again until done() or that is false.
  bool provide(httplib::DataSink& sink) {
    constexpr int kPatienceMs = 5;
    if (!sink.is_writable()) return false;
    if (!runs_ && !begin()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(kPatienceMs));
      return true;
    }
    if (answer_ < 0) {
      static const std::string gone = encoded(
          {R"({"type":"error","message":"the process that does the jobs has ended; end mwt explore and start it again"})",
           ""});
      if (!sink.write(gone.data(), gone.size())) return false;
      sink.done();
      return true;
    }
    pollfd watched{answer_, POLLIN, 0};
    if (poll(&watched, 1, kPatienceMs) <= 0) return true;
    const ssize_t size = recv(answer_, block_.data(), block_.size(), 0);
    if (size < 0) return errno == EAGAIN || errno == EINTR;
    if (size == 0) {
      sink.done();
      return true;
    }
    return sink.write(block_.data(), static_cast<std::size_t>(size));
  }

 private:
  bool begin() {
    runs_ = places_.begin();
    if (!runs_) return false;
    try {
      answer_ = host_.start(request_);
    } catch (const std::system_error&) {  // provide() says so
    }
    request_ = {};
    return true;
  }

  const JobHost& host_;
  JobPlaces& places_;
  std::string request_;
  bool runs_ = false;
  int answer_ = -1;
  std::array<char, 1 << 16> block_{};
};

std::string_view type_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kTypes = {
      {{".html", "text/html; charset=utf-8"},
       {".css", "text/css; charset=utf-8"},
       {".js", "text/javascript; charset=utf-8"},
       {".json", "application/json"}}};
  for (const auto& [ending, type] : kTypes) {
    if (name.ends_with(ending)) return type;
  }
  return kBytes;
}

// httplib would read a longer body to its end.
bool is_too_long(const httplib::Request& request) {
  const auto length = parse_whole_number<std::uint64_t>(request.get_header_value("Content-Length"));
  return request.method == "POST" && (!length || *length > kMaxBody);
}

// Requests that httplib would read without a limit, or in ways that the page needs not.
bool has_unusual_body(const httplib::Request& request) {
  return request.has_header("Transfer-Encoding") || request.has_header("Content-Encoding") ||
         request.has_header("Range") || (request.method == "POST" && !request.has_header("Content-Length"));
}

void refuse(httplib::Response& response, int status, const std::string& why) {
  response.status = status;
  response.set_content("mwt explore: " + why + "\n", "text/plain");
}

// Regular expressions in httplib recurse over what they are given, lines of 8 KiB.
void give_threads_large_stacks() {
  constexpr std::size_t kStack = std::size_t{64} << 20;
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kStack);
  pthread_setattr_default_np(&attributes);
  pthread_attr_destroy(&attributes);
}

}  // namespace

class ExploreServer::Impl {
 public:
  Impl(const JobHost& host, ExploreOptions options)
      : host_(host),
        options_(std::move(options)),
        token_(random_token()),
        places_(options_.parallel_jobs, options_.waiting_jobs),
        port_(bind()),
        access_(token_, port_) {
    set_up();
  }

  [[nodiscard]] std::string address() const { return fmt::format("http://127.0.0.1:{}/{}/", port_, token_); }
  void serve() { server_.serve(); }
  void stop() { server_.end(); }

 private:
  // httplib lets other programs share its port, and the system keep five connections that are not accepted yet: many
  // at once would be lost. Here nobody shares the port, and listening again makes room.
  int bind() {
    int listening = -1;
    server_.set_socket_options([&listening](int socket) {
      listening = socket;
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    int port = options_.port;
    if (port == 0) {
      port = server_.bind_to_any_port(kLoopback);
    } else if (!server_.bind_to_port(kLoopback, port)) {
      throw InputError(fmt::format("--port {}: not free; give another one, or none", port));
    }
    if (port <= 0) throw std::runtime_error("no port of the loopback address is free");
    listen(listening, SOMAXCONN);
    server_.set_socket_options([](int) {});
    return port;
  }

  void set_up() {
    give_threads_large_stacks();
    server_.set_tcp_nodelay(true);
    server_.set_payload_max_length(kMaxBody);
    server_.set_default_headers({
        {"Cache-Control", "no-store"},
        {"Content-Security-Policy",
         "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'; "
         "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
        {"Cross-Origin-Opener-Policy", "same-origin"},
        {"Cross-Origin-Resource-Policy", "same-origin"},
        {"Referrer-Policy", "no-referrer"},
        {"X-Content-Type-Options", "nosniff"},
    });
    server_.set_pre_routing_handler([this](const auto& request, auto& response) { return admit(request, response); });
    server_.set_error_handler([](const httplib::Request&, httplib::Response& response) {
      if (response.body.empty()) refuse(response, response.status, "refused");
    });
    server_.set_exception_handler([](const httplib::Request&, httplib::Response& response, const std::exception_ptr&) {
      refuse(response, 500, "the request could not be served");
    });
    server_.Post("/" + token_ + "/job", [this](const auto& request, auto& response) { job(request, response); });
    server_.Post("/" + token_ + "/keep", [this](const auto& request, auto& response) { keep(request, response); });
  }

  // Everything is decided here, before a body is read, but for jobs that are admitted.
  httplib::Server::HandlerResponse admit(const httplib::Request& request, httplib::Response& response) {
    const std::string host = request.get_header_value("Host");
    const std::string origin = request.get_header_value("Origin");
    const bool is_ambiguous =
        request.get_header_value_count("Host") != 1 || request.get_header_value_count("Origin") > 1;
    const auto path = access_.granted(
        {host, request.has_header("Origin") ? std::optional<std::string_view>(origin) : std::nullopt, request.path});
    if (is_ambiguous || !path) {
      refuse(response, 403, "not allowed; open the address that the program has printed");
    } else if (has_unusual_body(request)) {
      refuse(response, 400, "a request needs a Content-Length, and neither encodings nor ranges");
    } else if (request.method == "GET") {
      serve_file(*path, response);
    } else if (request.method != "POST" || (*path != "job" && *path != "keep")) {
      refuse(response, 404, "there is no such thing here");
    } else if (request.get_header_value("Content-Type") != kBytes) {
      refuse(response, 415, std::string("a body is ") + kBytes);
    } else if (is_too_long(request)) {
      refuse(response, 413, fmt::format("a body has at most {} bytes", kMaxBody));
    } else {
      return httplib::Server::HandlerResponse::Unhandled;
    }
    return httplib::Server::HandlerResponse::Handled;
  }

  void serve_file(const std::string& path, httplib::Response& response) {
    constexpr std::string_view kKept = "kept/";
    if (path.starts_with(kKept)) return serve_kept(path.substr(kKept.size()), response);
    if (path == "catalogue.json") return response.set_content(options_.catalogue, "application/json");
    if (path == "given") return response.set_content(options_.given_points, kBytes);
    const std::string_view name = path.empty() ? "index.html" : std::string_view(path);
    const auto files = page_files();
    const auto file = std::ranges::find(files, name, &PageFile::name);
    if (file == files.end()) return refuse(response, 404, "there is no such file");
    response.set_content(file->content.data(), file->content.size(), std::string(type_of(name)));
  }

  void serve_kept(const std::string& name, httplib::Response& response) {
    const auto bytes = kept_.find(name);
    if (!bytes) return refuse(response, 404, "these points are not here, or no longer");
    response.set_content(*bytes, kBytes);
  }

  void keep(const httplib::Request& request, httplib::Response& response) {
    const std::optional<std::string> name = kept_.keep(request.body);
    if (!name) return refuse(response, 400, "these are no points that can be kept");
    response.set_content(*name, "text/plain");
  }

  void job(const httplib::Request& request, httplib::Response& response) {
    if (!places_.enter()) {
      response.set_header("Retry-After", "1");
      return refuse(response, 503, "too many jobs at once");
    }
    auto streamed = std::make_shared<StreamedJob>(host_, places_, request.body);
    response.set_chunked_content_provider(
        kBytes, [streamed](std::size_t, httplib::DataSink& sink) { return streamed->provide(sink); });
  }

  const JobHost& host_;
  ExploreOptions options_;
  std::string token_;
  JobPlaces places_;
  KeptPoints kept_{kMaxKept};
  AcceptingServer server_;
  int port_;
  Access access_;
};

ExploreServer::ExploreServer(const JobHost& host, ExploreOptions options)
    : impl_(std::make_unique<Impl>(host, std::move(options))) {}
ExploreServer::~ExploreServer() = default;
std::string ExploreServer::address() const { return impl_->address(); }
void ExploreServer::serve() { impl_->serve(); }
void ExploreServer::stop() { impl_->stop(); }

}  // namespace mwt

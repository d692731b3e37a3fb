// SPDX-License-Identifier: MIT
#include "engine/bench/cell_queue.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <list>
#include <thread>

#include "engine/io/text_output.h"

namespace svoscope {

namespace fs = std::filesystem;

namespace {

constexpr auto kPause = std::chrono::milliseconds(10);
constexpr double kGraceSeconds = 10;  // between asking a child to end and ending it

std::string hostName() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

class Queue {
 public:
  Queue(const std::vector<QueuedRun>& runs, const QueueOptions& options,
        const std::function<Status(std::size_t, const RunEnd&)>& done)
      : runs_(runs), options_(options), done_(done) {}

  Result<bool> run() {
    Status status = Done{};
    while (status.ok() && !stopped() && (next_ < runs_.size() || !running_.empty())) {
      if (next_ < runs_.size() && static_cast<int>(running_.size()) < options_.jobs) {
        status = start();
        continue;
      }
      if (!collect(status)) std::this_thread::sleep_for(kPause);
    }
    endAll();
    if (!status.ok()) return status.error();
    return !stopped();
  }

 private:
  struct Running {
    std::size_t index;
    ChildProcess child;
    bool timed_out = false;
  };

  bool stopped() const { return options_.stop && *options_.stop; }

  Status start() {
    const QueuedRun& run = runs_[next_];
    std::error_code ec;
    fs::remove_all(run.temporary, ec);
    const Status made = makeFolder(run.temporary);
    if (!made.ok()) return made;
    std::vector<std::string> argv = run.argv;
    argv.insert(argv.end(), {"--out", run.temporary.string()});
    auto child = ChildProcess::start(argv, run.temporary / "log.txt");
    if (!child.ok()) return child.error();
    running_.push_back({next_++, std::move(child).value()});
    return Done{};
  }

  /// True if one ended.
  bool collect(Status& status) {
    for (auto it = running_.begin(); it != running_.end(); ++it) {
      if (options_.timeout_s > 0 && !it->timed_out && it->child.seconds() > options_.timeout_s) {
        it->timed_out = true;
        it->child.signal(SIGKILL);
      }
      const auto end = it->child.poll();
      if (!end) continue;
      const Running ended = *it;
      running_.erase(it);
      if (!stopped()) status = done_(ended.index, {*end, ended.timed_out, ended.child.seconds()});
      std::error_code ec;
      fs::remove_all(runs_[ended.index].temporary, ec);
      return true;
    }
    return false;
  }

  /// What still runs is asked to end, then made to; half results are removed.
  void endAll() {
    for (const Running& r : running_) r.child.signal(SIGTERM);
    const auto asked = std::chrono::steady_clock::now();
    bool forced = false;
    while (!running_.empty()) {
      for (auto it = running_.begin(); it != running_.end();) {
        if (!it->child.poll()) {
          ++it;
          continue;
        }
        std::error_code ec;
        fs::remove_all(runs_[it->index].temporary, ec);
        it = running_.erase(it);
      }
      const std::chrono::duration<double> since = std::chrono::steady_clock::now() - asked;
      if (!forced && since.count() > kGraceSeconds) {
        for (const Running& r : running_) r.child.signal(SIGKILL);
        forced = true;
      }
      std::this_thread::sleep_for(kPause);
    }
  }

  const std::vector<QueuedRun>& runs_;
  const QueueOptions& options_;
  const std::function<Status(std::size_t, const RunEnd&)>& done_;
  std::list<Running> running_;
  std::size_t next_ = 0;
};

/// The process of a name made by temporaryBeside on this machine, 0 if it is none.
pid_t ownerOf(const std::string& name) {
  const std::string mark = "@" + hostName() + ".";
  const std::size_t at = name.find(mark);
  if (name.empty() || name[0] != '.' || at == std::string::npos) return 0;
  pid_t pid = 0;
  const char* begin = name.data() + at + mark.size();
  const auto [stop, error] = std::from_chars(begin, name.data() + name.size(), pid);
  return error == std::errc() && std::string(stop) == ".tmp" ? pid : 0;
}

}  // namespace

Result<bool> runQueue(const std::vector<QueuedRun>& runs, const QueueOptions& options,
                      const std::function<Status(std::size_t, const RunEnd&)>& done) {
  return Queue(runs, options, done).run();
}

fs::path temporaryBeside(const fs::path& folder) {
  return folder.parent_path() /
         fmt::format(".{}@{}.{}.tmp", folder.filename().string(), hostName(), getpid());
}

void removeAbandoned(const fs::path& root) {
  std::vector<fs::path> abandoned;
  std::error_code ec;
  for (fs::recursive_directory_iterator it(root, ec), end; !ec && it != end; it.increment(ec)) {
    const pid_t owner = ownerOf(it->path().filename().string());
    if (owner <= 0) continue;
    it.disable_recursion_pending();
    if (kill(owner, 0) != 0 && errno == ESRCH) abandoned.push_back(it->path());
  }
  for (const fs::path& folder : abandoned) fs::remove_all(folder, ec);
}

}  // namespace svoscope

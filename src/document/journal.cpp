// The writing half of the journal; journal_reader.cpp reads it back.
#include "document/journal.h"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include "core/file.h"
#include "document/assets.h"
#include "document/document_json.h"
#include "document/journal_files.h"
#include "document/journal_text.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

std::int64_t millisecondsNow() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

struct Step {
  Document document;
  std::string what;
  JournalOrigin origin;
  std::int64_t milliseconds = 0;
};

/// The files; knows no threads. After an exception the next step starts again with a base.
class Writer {
 public:
  explicit Writer(fs::path folder) : folder_(std::move(folder)) {}

  void record(Step step) {
    try {
      write(step);
    } catch (...) {
      steps_.close();
      last_ = std::move(step);  // the next snapshot tries again
      throw;
    }
    last_ = std::move(step);
  }

  void snapshot() {
    if (last_ && (sinceBase_ > 0 || !steps_.isOpen())) writeBase(*last_);
  }

  void clear() {
    steps_.close();
    last_.reset();
    assets_.clear();
    unsynced_.clear();
    removeAtOnce(folder_);
  }

  void sync() {
    for (const fs::path& file : unsynced_) {
      AppendedFile asset;
      asset.open(file);
      asset.sync();
    }
    unsynced_.clear();
    if (steps_.isOpen()) steps_.sync();
  }

  void broken() { steps_.close(); }

 private:
  void write(const Step& step) {
    if (!steps_.isOpen() || !last_ || last_->origin != step.origin) return writeBase(step);
    keepAssets(step.document);
    Value line = journalStep(last_->document, step.document);
    line["what"] = step.what;
    line["time"] = step.milliseconds;
    steps_.append(journalLine(line));
    ++sinceBase_;
  }

  // Written in place before the step that names them; a torn one does not have the content that its name tells.
  void keepAssets(const Document& document) {
    for (const std::string& hash : namedAssets(document)) {
      if (assets_.contains(hash)) continue;
      fs::create_directories(journalAssets(folder_));
      const fs::path file = journalAssets(folder_) / hash;
      fs::remove(file);
      AppendedFile asset;
      asset.open(file);
      asset.append(*document.assets().at(hash));
      unsynced_.push_back(file);
      assets_.insert(hash);
    }
  }

  void writeBase(const Step& step) {
    fs::create_directories(folder_);
    keepAssets(step.document);
    const Value base{{"journal", 1},      {"file", step.origin.file.string()}, {"name", step.origin.name},
                     {"what", step.what}, {"time", step.milliseconds},         {"document", documentJson(step.document)}};
    const std::size_t next = generation_ + 1;
    std::error_code ignored;
    fs::remove(journalSteps(folder_, next), ignored);
    writeAtomically(journalBase(folder_, next), journalLine(base));
    steps_.open(journalSteps(folder_, next));
    fs::remove(journalBase(folder_, generation_), ignored);
    fs::remove(journalSteps(folder_, generation_), ignored);
    generation_ = next;
    sinceBase_ = 0;
  }

  fs::path folder_;
  AppendedFile steps_;
  std::optional<Step> last_;
  std::set<std::string> assets_;
  std::vector<fs::path> unsynced_;
  std::size_t generation_ = 0;
  std::size_t sinceBase_ = 0;
};

}  // namespace

struct Journal::State {
  enum class Act { Record, Snapshot, Clear, Tell };
  struct Task {
    Act act;
    Step step = {};
    std::function<void()> then = {};
  };

  State(fs::path folder, Problem told) : writer(std::move(folder)), problem(std::move(told)) {}

  void ask(Task task) {
    {
      const std::scoped_lock lock(guard);
      if (task.act == Act::Clear) tasks.clear();  // no longer needed
      tasks.push_back(std::move(task));
      if (!thread.joinable()) thread = std::thread([this] { work(); });
    }
    changed.notify_all();
  }

  void work() {
    std::unique_lock lock(guard);
    for (;;) {
      changed.wait(lock, [this] { return ending || !tasks.empty(); });
      if (tasks.empty()) return;
      std::deque<Task> taken;
      taken.swap(tasks);
      busy = true;
      lock.unlock();
      write(taken);
      lock.lock();
      busy = false;
      changed.notify_all();
    }
  }

  void write(std::deque<Task>& taken) {
    bool all = true;  // a failure must not prevent later steps: the last one counts
    for (Task& task : taken) {
      all &= tried([&] {
        if (task.act == Act::Record) writer.record(std::move(task.step));
        if (task.act == Act::Snapshot) writer.snapshot();
        if (task.act == Act::Clear) writer.clear();
      });
    }
    all &= tried([&] { writer.sync(); });
    if (!all) return;
    failing = false;
    for (const Task& task : taken)
      if (task.act == Act::Tell) task.then();
  }

  bool tried(const std::function<void()>& work) {
    try {
      work();
      return true;
    } catch (const Error& error) {
      complain(error);
    } catch (const std::exception& error) {  // std::filesystem's own
      complain(Error(ErrorCode::FileUnwritable, std::string("The safety copy cannot be written: ") + error.what() + ".",
                     "Check that the disk is not full."));
    }
    return false;
  }

  void complain(const Error& error) {
    writer.broken();
    if (!failing && problem) problem(error);
    failing = true;
  }

  std::mutex guard;
  std::condition_variable changed;
  std::deque<Task> tasks;
  bool busy = false, ending = false;
  Writer writer;         // of the thread alone
  bool failing = false;  // likewise
  Problem problem;
  std::thread thread;
};

Journal::Journal(fs::path folder, Problem problem)
    : state_(std::make_unique<State>(std::move(folder), std::move(problem))) {}

Journal::~Journal() {
  {
    const std::scoped_lock lock(state_->guard);
    state_->ending = true;
  }
  state_->changed.notify_all();
  if (state_->thread.joinable()) state_->thread.join();
}

void Journal::record(Document document, std::string what, JournalOrigin origin) {
  state_->ask({State::Act::Record, {std::move(document), std::move(what), std::move(origin), millisecondsNow()}});
}
void Journal::snapshot() { state_->ask({State::Act::Snapshot}); }
void Journal::clear() { state_->ask({State::Act::Clear}); }
void Journal::whenKept(std::function<void()> then) { state_->ask({State::Act::Tell, {}, std::move(then)}); }

void Journal::settle() {
  std::unique_lock lock(state_->guard);
  state_->changed.wait(lock, [this] { return state_->tasks.empty() && !state_->busy; });
}

}  // namespace blossom

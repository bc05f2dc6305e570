#pragma once
#include <unistd.h>

#include <atomic>

namespace blossom {

/// The one T of this process. It is never destroyed, because threads may still use it while the process ends. A process made
/// by fork has neither threads nor children of the one it was copied from, so it gets a new T.
template <class T>
T& ofThisProcess() {
  struct Owned {
    const pid_t owner = ::getpid();
    T value{};
  };
  static std::atomic<Owned*> current{nullptr};
  Owned* known = current.load();
  if (known && known->owner == ::getpid()) return known->value;
  auto* made = new Owned;
  if (current.compare_exchange_strong(known, made)) return made->value;
  delete made;  // another thread was quicker
  return known->value;
}

}  // namespace blossom

#include <cstdlib>

#include "core/memory.h"
#include "exchange/cad/worker_calls.h"
#include "worker/worker.h"

int main() {
  blossom::keepFreedMemory();
  // A file whose date is given must not differ from one time zone to the next.
  if (const char* date = std::getenv("SOURCE_DATE_EPOCH"); date && *date) ::setenv("TZ", "UTC", 1);
  blossom::registerExchangeCalls();
  // Not through exit(): destroying the static objects of the libraries would only take time.
  std::_Exit(blossom::workerMain());
}

#include <cstdlib>

#include "exchange/worker_calls.h"
#include "worker/worker.h"

int main() {
  blossom::registerExchangeCalls();
  // Not through exit(): taking down what the libraries hold at static lifetime takes time and serves nobody.
  std::_Exit(blossom::workerMain());
}

#include "support/test_main.h"

#include <filesystem>
#include <iostream>
#include <map>

#include "core/memory.h"

/// The program of several tests runs the one that it is called by: the links to it beside it bear their names. Called by its
/// own name, it takes that of a test as its first argument.
namespace blossom::test {
namespace {

std::map<std::string, TestRun>& tests() {
  static std::map<std::string, TestRun> all;
  return all;
}

}  // namespace

RegisteredTest::RegisteredTest(const char* file, TestRun run) {
  tests().emplace(std::filesystem::path(file).stem().string(), run);
}

}  // namespace blossom::test

int main(int argc, char** argv) {
  blossom::keepFreedMemory();  // as the programs do
  const auto& tests = blossom::test::tests();
  if (const auto called = tests.find(std::filesystem::path(argv[0]).filename().string()); called != tests.end())
    return called->second(argc, argv);
  if (argc > 1)
    if (const auto named = tests.find(argv[1]); named != tests.end()) return named->second(argc - 1, argv + 1);
  std::cerr << "Give the name of a test:\n";
  for (const auto& [name, run] : tests) std::cerr << "  " << name << '\n';
  return 2;
}

#pragma once
#include <QCoreApplication>
#include <QtTest>

namespace blossom::test {

/// What runs one test class with the arguments of its program.
using TestRun = int (*)(int argc, char** argv);

/// Makes a test class known to main() under the name of its file.
struct RegisteredTest {
  RegisteredTest(const char* file, TestRun);
};

template <class Test, class Application = QCoreApplication>
int runTest(int argc, char** argv) {
  Application application(argc, argv);
  Test test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace blossom::test

/// Several test files are compiled into one program, which is called by the name of each (see test_main.cpp).
#define BLOSSOM_TEST_RUN(Class, run) static const blossom::test::RegisteredTest registered##Class(__FILE__, run);
#define BLOSSOM_TEST(Class) BLOSSOM_TEST_RUN(Class, &blossom::test::runTest<Class>)

#pragma once
#include <QApplication>

#include "support/test_main.h"
#include "ui/window/application.h"

namespace blossom::test {

/// Runs a test class of widgets, with the settings of the window.
template <class Test>
int runWidgetTest(int argc, char** argv) {
  ui::prepareApplication();
  return runTest<Test, QApplication>(argc, argv);
}

}  // namespace blossom::test

#define BLOSSOM_WIDGET_TEST(Class) BLOSSOM_TEST_RUN(Class, &blossom::test::runWidgetTest<Class>)

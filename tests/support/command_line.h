#pragma once
#include <QProcess>
#include <QStringList>
#include <string>

#include "parameter/value.h"
#include "support/support.h"

/// The real command line, called as a user's script calls it.
namespace blossom::test {

inline QString blossomProgram() { return QString::fromStdString((buildFolder() / "bin/blossom").string()); }

/// What a command with --json prints.
struct Answer {
  int code = -1;  ///< -1 when it crashed
  Value json;
  [[nodiscard]] double result(const char* name) const { return json["result"][name].get<double>(); }
  [[nodiscard]] std::string message() const { return json["error"]["message"].get<std::string>(); }
  [[nodiscard]] std::string hint() const { return json["error"].value("hint", ""); }
};

/// Waits for its end, however long a busy machine takes: a test that hangs is ended by who runs the tests.
inline Answer answerOf(const QString& folder, QStringList arguments) {
  QProcess process;
  process.setWorkingDirectory(folder);
  process.start(blossomProgram(), arguments << "--json");
  if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit) return {};
  return {process.exitCode(), Value::parse(process.readAllStandardOutput().toStdString(), nullptr, false)};
}

}  // namespace blossom::test

#pragma once
#include <atomic>

#include "ui/tree/document_model.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

namespace blossom::ui {

/// The real window with feature types of its own: blocks made at once, one that waits until it is let go, one that fails.
class TreeFixture : public WindowFixture {
 protected:
  static Feature feature(const std::string& id, const std::string& type, std::vector<FeatureId> inputs = {},
                         const std::string& name = {}) {
    Feature made;
    made.id = id;
    made.type = type;
    made.name = name.empty() ? id : name;
    made.inputs = std::move(inputs);
    return made;
  }

  void openTestWindow() {
    letGo_ = false;
    App app = loadApp({test::buildFolder() / "lib/blossom/plugins"});
    auto registry = std::make_shared<Registry>(*app.registry);
    registry->add(block());
    registry->add(waiting());
    registry->add(failing());
    app.registry = registry;
    window_ = std::make_unique<MainWindow>(std::move(app));
    window_->resize(1000, 700);
    window_->show();
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  }

  void closeTestWindow() {
    letGo_ = true;
    window_.reset();
  }

  /// A, B = joined(A), C, D = joined(B, C): all visible and computed.
  void showChain() {
    const Document document = Document::of({feature("a", "test.block"), feature("b", "test.block", {"a"}),
                                            feature("c", "test.block"), feature("d", "test.block", {"b", "c"})});
    window_->session().commit(document, QStringLiteral("Add blocks"));
    waitUntilComputed();
  }

  void openChain() {
    openTestWindow();
    showChain();
  }

  void waitUntilComputed() { QTRY_VERIFY_WITH_TIMEOUT(!window_->session().evaluating(), 60000); }

  [[nodiscard]] const Document& document() const { return window_->session().document(); }
  [[nodiscard]] std::vector<FeatureId> order() const {
    std::vector<FeatureId> ids;
    for (const auto& each : document().features()) ids.push_back(each->id);
    return ids;
  }
  [[nodiscard]] QString undoText() const { return QString::fromStdString(window_->session().history().undoText()); }
  void undo() { window_->commands().action(QStringLiteral("edit.undo"))->trigger(); }
  void trigger(const char* command) {
    QAction* action = window_->commands().action(QLatin1String(command));
    QVERIFY2(action->isEnabled(), command);
    action->trigger();
  }
  [[nodiscard]] QModelIndex row(const char* id) {
    const auto found = window_->tree().model()->match(window_->tree().model()->index(0, 0), DocumentModel::IdRole,
                                                      QLatin1String(id), 1, Qt::MatchExactly);
    return found.isEmpty() ? QModelIndex() : found.front();
  }
  void choose(const std::vector<FeatureId>& ids) {
    window_->tree().clearSelection();
    for (const FeatureId& id : ids) window_->tree().select(id, true);
    QCOMPARE(window_->tree().selected().size(), ids.size());
  }

  /// Set before a test lets "test.waiting" go.
  static inline std::atomic<bool> letGo_ = false;

 private:
  struct None {};
  static Evaluated tetrahedron() {
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}};
    mesh.faceVertices = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    mesh.faceStarts = {0, 3, 6, 9, 12};
    return {std::move(mesh), Value::object(), {}};
  }
  static FeatureType block() {
    return blossom::feature<None>("test.block", "Block", "A tetrahedron.")
        .input({"part", "What it is joined to.", {ShapeKind::Mesh}, 0, anyNumber})
        .evaluate([](const None&, const Inputs&, const Progress&) { return tetrahedron(); });
  }
  static FeatureType waiting() {
    return blossom::feature<None>("test.waiting", "Waiting", "Waits until it is let go.")
        .input({"part", "Anything.", {ShapeKind::Mesh}, 0, anyNumber})
        .evaluate([](const None&, const Inputs&, const Progress& progress) {
          while (!letGo_) progress.report(0.25, "waiting");
          return tetrahedron();
        });
  }
  static FeatureType failing() {
    return blossom::feature<None>("test.failing", "Failing", "Cannot be made.")
        .input({"part", "Anything.", {ShapeKind::Mesh}, 0, anyNumber})
        .evaluate([](const None&, const Inputs&, const Progress&) -> Evaluated {
          throw Error(ErrorCode::InvalidInput, "The tool of 12 mm is too large.", "A tool of 4.8 mm would fit.");
        });
  }
};

}  // namespace blossom::ui

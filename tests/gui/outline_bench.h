#pragma once
#include <QKeyEvent>

#include "app/app.h"
#include "geometry/planar/planar.h"
#include "support/support.h"
#include "ui/plugin/tool.h"
#include "ui/window/manipulator_loader.h"

namespace blossom::ui {

/// A workbench without a window that evaluates at once and tells its tool of every change.
class Workbench : public ToolHost {
 public:
  explicit Workbench(const App& app) : app_(app), evaluator_(app.registry) {
    QVERIFY(loadManipulators(tools_, app.plugins).empty());
  }

  [[nodiscard]] const Document& document() const override { return shown_ ? *shown_ : documents_.back(); }
  [[nodiscard]] std::shared_ptr<const FeatureResult> result(const FeatureId& id) const override {
    const auto it = results_.find(id);
    return it == results_.end() ? nullptr : it->second;
  }
  [[nodiscard]] const Registry& registry() const override { return *app_.registry; }
  [[nodiscard]] const Look& look() const override { return look_; }
  [[nodiscard]] double gridSpacing() const override { return 10; }
  [[nodiscard]] std::vector<FeatureId> selection() const override { return selected_; }
  void select(const FeatureId& id) override { selected_ = {id}; }
  void preview(Document document) override {
    shown_ = std::move(document);
    ++previews;
    changed();
  }
  void endPreview() override {
    shown_.reset();
    changed();
  }
  void commit(Document document, const QString&) override {
    shown_.reset();
    documents_.push_back(std::move(document));
    changed();
  }

  /// One step back, as the user takes it.
  void undo() {
    shown_.reset();
    documents_.pop_back();
    changed();
  }
  FeatureId add(const char* type, const Value& parameters) {
    Feature feature{document().freshId("outline"), type, "Outline", {}, {}, true, false, Value::object()};
    feature.parameters = completed(registry().at(type)->parameters, parameters);
    const FeatureId id = feature.id;
    commit(document().with(std::move(feature)), {});
    return id;
  }
  Tool& start(const MakeTool& make, const FeatureId& id = {}) {
    tool = make(*this, id);
    QObject::connect(tool.get(), &Tool::changed, tool.get(), [this] { (void)tool->props(); });
    return *tool;
  }
  Tool& draw(const FeatureId& id = {}) { return start(tools_.toolFor("modeling.outline")->make, id); }
  Tool& handles(const FeatureId& id) { return start(*tools_.handles(document().at(id).type), id); }

  [[nodiscard]] std::size_t steps() const { return documents_.size() - 1; }
  [[nodiscard]] Region region(const FeatureId& id) const {
    const auto found = result(id);
    const Region* value = found ? found->evaluated.shape.get<Region>() : nullptr;
    return value ? *value : Region();
  }

  std::unique_ptr<Tool> tool;
  int previews = 0;

 private:
  void changed() {
    results_ = evaluator_.evaluate(document(), Progress::none());
    if (tool) tool->documentChanged();
  }
  const App& app_;
  ManipulatorRegistry tools_;
  Evaluator evaluator_;
  std::vector<Document> documents_{Document()};
  std::optional<Document> shown_;
  Results results_;
  std::vector<FeatureId> selected_;
  Look look_ = Look::dark();
};

/// Looked at from above at ten pixels a millimetre.
inline ToolEvent at(double x, double y, Qt::MouseButton button = Qt::NoButton, Qt::KeyboardModifiers modifiers = {}) {
  ToolEvent event;
  event.ray = {{x, y, 100}, {0, 0, -1}};
  event.button = button;
  event.modifiers = modifiers;
  event.millimetresPerPixel = 0.1;
  return event;
}

inline void click(Tool& tool, double x, double y, Qt::KeyboardModifiers modifiers = {}) {
  tool.move(at(x, y, Qt::NoButton, modifiers));
  QVERIFY(tool.press(at(x, y, Qt::LeftButton, modifiers)));
  tool.release(at(x, y, Qt::LeftButton, modifiers));
}

inline void drag(Tool& tool, const Vec2& from, const Vec2& to) {
  tool.move(at(from.x(), from.y()));
  QVERIFY(tool.press(at(from.x(), from.y(), Qt::LeftButton)));
  for (int k = 1; k <= 4; ++k) {
    const Vec2 p = from + (to - from) * k / 4;
    QVERIFY(tool.move(at(p.x(), p.y(), Qt::NoButton)));
  }
  QVERIFY(tool.release(at(to.x(), to.y(), Qt::LeftButton)));
}

inline bool key(Tool& tool, int code, const QString& text = {}) {
  return tool.key(QKeyEvent(QEvent::KeyPress, code, Qt::NoModifier, text));
}

inline void type(Tool& tool, const char* text) {
  for (; *text; ++text) QVERIFY(key(tool, QChar::fromLatin1(*text).toUpper().unicode(), QString(QChar::fromLatin1(*text))));
}

inline Value squarePoints() { return {{{"to", {40, 0, 0}}}, {{"to", {40, 40, 0}}}, {{"to", {0, 40, 0}}}}; }

/// Tests of the tools for outlines, as the module of the plugin gives them, driven by mouse and key events.
class OutlineFixture : public QObject {
 protected:
  const App app_ = loadApp();
};

}  // namespace blossom::ui

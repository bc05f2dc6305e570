#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ui/plugin/tool.h"
#include "window_fixture.h"

namespace blossom::ui {

/// A sample of the plugin sweep in the real window, with the mouse over its surface.
class SweepFixture : public WindowFixture {
 protected:
  /// From the file to its sweep, which is selected and seen from a corner.
  void openSample(const char* name);
  void key(Qt::Key key) { QTest::keyClick(&window_->view(), key); }
  /// Waits until the surface can be taken hold of.
  void hover(const QPoint& at);
  /// Waits until the hint there begins so.
  void hover(const QPoint& at, const QString& hint);
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {});
  [[nodiscard]] QString hint() const { return window_->page().tool() ? window_->page().tool()->hint() : QString(); }
  /// A place of the cylinder about z at half its height that is seen neither from the front nor edge on.
  [[nodiscard]] QPoint onTheSide() const;
  /// Looks at the propeller from the top. @returns a place of one of its blades.
  [[nodiscard]] QPoint onABlade();
  [[nodiscard]] const Document& document() const { return window_->page().document(); }
  [[nodiscard]] std::vector<FeatureId> all(const char* type) const;
  [[nodiscard]] const Feature& only(const char* type) const { return document().at(all(type).front()); }
  [[nodiscard]] const Motion& motionOf(const FeatureId& id) const {
    return *window_->session().view(id)->result->evaluated.shape.get<Motion>();
  }
  [[nodiscard]] const Surface& surfaceOf(const FeatureId& id) const {
    return *window_->session().view(id)->result->evaluated.shape.get<Surface>();
  }
  static Vec3 vectorOf(const Value& p) { return {p[0].get<double>(), p[1].get<double>(), p[2].get<double>()}; }
  /// Of both themes, kept where BLOSSOM_PICTURES says, to be looked at. @param at where the mouse is moved before
  void keepPictures(const char* name, std::optional<QPoint> at = {});

  FeatureId source_, sweep_;
};

}  // namespace blossom::ui

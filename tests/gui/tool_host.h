#pragma once
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <map>

#include "feature/registry.h"
#include "ui/plugin/tool.h"

namespace blossom::ui {

/// A workbench without a window: a document with results put in by hand.
class TestHost : public ToolHost {
 public:
  void put(const FeatureId& id, const Shape& shape) {
    Feature feature;
    feature.id = id;
    feature.type = "test.shape";
    feature.name = id;
    document_ = document_.with(feature);
    results_[id] = std::make_shared<const FeatureResult>(FeatureResult{{shape, {}, {}}, Value::object(), {}, 0, false});
  }
  void setDocument(Document document) { document_ = std::move(document); }

  [[nodiscard]] const Document& document() const override { return document_; }
  [[nodiscard]] std::shared_ptr<const FeatureResult> result(const FeatureId& id) const override {
    const auto it = results_.find(id);
    return it == results_.end() ? nullptr : it->second;
  }
  [[nodiscard]] const Registry& registry() const override { return registry_; }
  [[nodiscard]] const Look& look() const override { return look_; }
  [[nodiscard]] double gridSpacing() const override { return 5; }
  [[nodiscard]] std::vector<FeatureId> selection() const override { return {}; }
  void select(const FeatureId&) override {}
  [[nodiscard]] std::optional<CutPlane> section() const override { return section_; }
  void setSection(const std::optional<CutPlane>& plane) override {
    section_ = plane;
    ++cuts;
  }
  [[nodiscard]] Bounds extent() const override {
    Bounds box;
    for (const auto& [id, result] : results_) box.add(bounds(result->evaluated.shape));
    return box;
  }
  void preview(Document document) override { document_ = std::move(document); }
  void endPreview() override {}
  void commit(Document document, const QString&) override { document_ = std::move(document); }

  int cuts = 0;

 private:
  Document document_;
  std::map<FeatureId, std::shared_ptr<const FeatureResult>> results_;
  Registry registry_;
  Look look_ = Look::dark();
  std::optional<CutPlane> section_;
};

inline Shape box(double x, double y, double z, double dx = 0) {
  return Shape(Brep(BRepPrimAPI_MakeBox(gp_Pnt(dx, 0, 0), x, y, z).Shape()));
}

}  // namespace blossom::ui

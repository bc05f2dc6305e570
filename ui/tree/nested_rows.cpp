#include "ui/tree/nested_rows.h"

#include <map>

namespace blossom::ui {

namespace {

class Nester {
 public:
  Nester(const Document& document, const Registry& registry, const ShapeOf& shapeOf) : document_(document) {
    static const Shape expected{Region()};
    const auto shape = [&](const FeatureId& id) {
      const Shape* known = shapeOf(id);
      return known ? known : &expected;
    };
    for (const auto& feature : document.features()) {
      std::vector<FeatureId> gone = inputsByUse(*feature, registry, shape).consumed;
      if (feature->suppressed && !feature->inputs.empty()) gone = {feature->inputs.front()};  // whose shape it passes on
      for (const FeatureId& id : gone) user_[id] = feature->id;                               // the last one that uses it
    }
    for (const auto& feature : document.features())
      if (const auto user = user_.find(feature->id); user != user_.end()) steps_[user->second].push_back(feature->id);
  }

  std::vector<NestedRow> rows() {
    for (const auto& feature : document_.features())
      if (!user_.contains(feature->id)) add(feature->id, {}, 0);
    return std::move(rows_);
  }

 private:
  void add(const FeatureId& id, const FeatureId& parent, int depth) {
    const std::vector<FeatureId> steps = stepsOf(id);
    const bool inLine = depth > 0 && steps.size() == 1;  // its step follows it in the same line
    rows_.push_back({shared(id), parent, depth, !steps.empty() && !inLine});
    for (const FeatureId& step : steps) add(step, inLine ? parent : id, inLine ? depth : depth + 1);
  }
  [[nodiscard]] std::vector<FeatureId> stepsOf(const FeatureId& id) const {
    const auto found = steps_.find(id);
    return found == steps_.end() ? std::vector<FeatureId>() : found->second;
  }
  [[nodiscard]] std::shared_ptr<const Feature> shared(const FeatureId& id) const { return byId_.at(id); }

  const Document& document_;
  std::map<FeatureId, FeatureId> user_;
  std::map<FeatureId, std::vector<FeatureId>> steps_;
  std::map<FeatureId, std::shared_ptr<const Feature>> byId_ = [this] {
    std::map<FeatureId, std::shared_ptr<const Feature>> all;
    for (const auto& feature : document_.features()) all.emplace(feature->id, feature);
    return all;
  }();
  std::vector<NestedRow> rows_;
};

}  // namespace

std::vector<NestedRow> nestedRows(const Document& document, const Registry& registry, const ShapeOf& shapeOf) {
  return Nester(document, registry, shapeOf).rows();
}

}  // namespace blossom::ui

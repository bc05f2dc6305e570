#pragma once
#include <memory>
#include <vector>

#include "ui/plugin/tool.h"

namespace blossom::sweep {

/// The surface as a drag left it, shown until the features it stands for have a result of the new document: what was let go
/// does not jump back meanwhile.
class LingeringPicture {
 public:
  /// Before the change, of which the picture is.
  LingeringPicture(const ui::ToolHost&, ui::StandIn);
  /// After it.
  void begin(const ui::ToolHost& host) { document_ = host.document(); }

  /// The results are there, or the document is another one.
  [[nodiscard]] bool over(const ui::ToolHost&) const;
  /// Whether the ray meets one of its faces.
  [[nodiscard]] bool isHit(const Ray&) const;
  [[nodiscard]] const ui::StandIn& picture() const { return picture_; }

 private:
  ui::StandIn picture_;
  Document document_;
  std::vector<std::shared_ptr<const FeatureResult>> before_;  ///< of the features that it stands for
};

}  // namespace blossom::sweep

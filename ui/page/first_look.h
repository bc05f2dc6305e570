#pragma once

namespace blossom::ui {

class ViewWidget;

/// Where a document is looked at from before the user has turned the view: a drawing from above, anything else from a
/// corner; what the user has drawn in the view, as it was looked at before.
class FirstLook {
 public:
  /// Another document is going to be shown.
  void expect();
  [[nodiscard]] bool pending() const { return pending_; }
  [[nodiscard]] bool awaitsSolid() const { return fromAbove_; }
  /// The user has drawn in the view, and so has seen where it looks from.
  void drawn() { drawn_ = true; }
  /// The first shapes of the document are shown.
  void show(ViewWidget&);
  /// There is a solid. What it was made of may have been looked at from above, where no height is seen.
  void showSolid(ViewWidget&, bool mayTurn);

 private:
  bool pending_ = true, drawn_ = false;
  bool fromAbove_ = false;  ///< by itself, until there is a solid
};

}  // namespace blossom::ui

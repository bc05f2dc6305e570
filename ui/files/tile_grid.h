#pragma once
#include <QWidget>
#include <vector>

class QGridLayout;

namespace blossom::ui {

class Tile;

/// Tiles in as many columns as fit.
class TileGrid : public QWidget {
  Q_OBJECT
 public:
  explicit TileGrid(QWidget* parent = nullptr);
  void setTiles(std::vector<Tile*>);  ///< takes ownership; deletes the previous ones
  [[nodiscard]] const std::vector<Tile*>& tiles() const { return tiles_; }

  /// One column: how many there are follows the width.
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent*) override;

 private:
  void arrange();
  QGridLayout* grid_;
  std::vector<Tile*> tiles_;
  int columns_ = 0;
};

}  // namespace blossom::ui

#include "ui/files/tile_grid.h"

#include <QGridLayout>
#include <algorithm>

#include "ui/files/tile.h"

namespace blossom::ui {

namespace {
constexpr int tileGap = 12;
}

TileGrid::TileGrid(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(tileGap);
  grid_->setSizeConstraint(QLayout::SetNoConstraint);  // its columns follow the width, not the other way round
}

void TileGrid::setTiles(std::vector<Tile*> tiles) {
  for (Tile* old : tiles_) old->deleteLater();
  tiles_ = std::move(tiles);
  for (Tile* tile : tiles_) tile->setParent(this);
  columns_ = 0;
  arrange();
}

void TileGrid::arrange() {
  const int columns = std::max(1, (width() + tileGap) / (Tile::smallestWidth + tileGap));
  if (columns == columns_) return;
  columns_ = columns;
  while (QLayoutItem* item = grid_->takeAt(0)) delete item;
  for (int column = 0; column < 32; ++column) grid_->setColumnStretch(column, column < columns ? 1 : 0);
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    const int place = static_cast<int>(i);
    grid_->addWidget(tiles_[i], place / columns, place % columns);
    tiles_[i]->show();
  }
  const int rows = (static_cast<int>(tiles_.size()) + columns - 1) / columns;
  for (int row = 0; row < grid_->rowCount(); ++row) grid_->setRowMinimumHeight(row, row < rows ? Tile::height : 0);
  setFixedHeight(std::max(0, rows * (Tile::height + tileGap) - tileGap));
}

QSize TileGrid::minimumSizeHint() const { return {Tile::smallestWidth, 0}; }

void TileGrid::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

}  // namespace blossom::ui

#pragma once
#include <QPushButton>

class QLabel;

namespace blossom::ui {

/// A file as a tile: picture, title, one line of description. A button for mouse and keyboard.
class Tile : public QPushButton {
  Q_OBJECT
 public:
  static constexpr QSize pictureSize{150, 84};
  static constexpr int smallestWidth = 172;
  static constexpr int height = 146;  ///< fixed here, because style sheets set another minimum height of buttons

  Tile(const QString& file, const QString& title, const QString& about, QWidget* parent = nullptr);
  [[nodiscard]] const QString& file() const { return file_; }
  void setPicture(const QPixmap&);
  [[nodiscard]] bool hasPicture() const { return pictured_; }
  void setPinned(bool);
  /// Marks the file as missing: the tile is drawn faintly with a note.
  void setMissing();

 protected:
  void resizeEvent(QResizeEvent*) override;

 private:
  void elide();
  QString file_, titleText_, aboutText_;
  bool pictured_ = false;
  QLabel *picture_, *title_, *about_, *pin_;
};

}  // namespace blossom::ui

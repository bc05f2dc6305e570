#pragma once
#include <QPushButton>

class QLabel;

namespace blossom::ui {

/// A file as a tile: picture, title, one line about it. A button for mouse and keyboard alike.
class Tile : public QPushButton {
  Q_OBJECT
 public:
  static constexpr QSize pictureSize{150, 84};
  static constexpr int smallestWidth = 172;
  static constexpr int height = 146;  ///< said here, for a style sheet has its own idea of the least height of a button

  Tile(const QString& file, const QString& title, const QString& about, QWidget* parent = nullptr);
  [[nodiscard]] const QString& file() const { return file_; }
  void setPicture(const QPixmap&);
  [[nodiscard]] bool hasPicture() const { return pictured_; }
  void setPinned(bool);
  /// The file is not there any more: the tile turns faint and says so.
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

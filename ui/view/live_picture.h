#pragma once
#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QTimer>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ui/view/smoothing.h"

class QWidget;
class vtkRenderer;

namespace blossom::ui {

class Painter;

/// What a live picture is drawn of.
class PictureSubject {
 public:
  PictureSubject() = default;
  virtual ~PictureSubject() = default;
  PictureSubject(const PictureSubject&) = delete;
  PictureSubject& operator=(const PictureSubject&) = delete;

  [[nodiscard]] virtual vtkRenderer& renderer() = 0;
  [[nodiscard]] virtual bool stale() const = 0;       ///< its contents are out of date
  virtual void bringUpToDate() = 0;                   ///< asks for another frame when that has changed anything
  [[nodiscard]] virtual bool incomplete() const = 0;  ///< pieces of it are still to come, one for each frame
  virtual void bringNextPiece() = 0;
  [[nodiscard]] virtual bool empty() const = 0;
  [[nodiscard]] virtual bool canBeCoarser() const = 0;  ///< it has a picture of fewer triangles
  /// Called before each frame. @param offset device pixels by which the frame is to lie aside  @param coarse it is to be
  /// drawn of fewer triangles, where it can  @param share of the pixels along each side that are drawn
  virtual void prepareFrame(QPointF offset, QSize picture, bool coarse, double share) = 0;
};

/// The picture that a widget shows of a renderer. Frames are begun here, drawn beside what the window does, and shown when
/// they are there; nothing is drawn while nothing changes. While something moves and frames take too long, they are drawn of
/// fewer triangles, then with half the size; all edges are smoothed when things have come to rest.
class LivePicture : public QObject {
  Q_OBJECT
 public:
  LivePicture(QWidget& widget, PictureSubject&);
  ~LivePicture() override;

  [[nodiscard]] Painter& painter() { return *painter_; }
  [[nodiscard]] QString problem() const;  ///< why nothing can be drawn; empty when all is well
  void redraw();                          ///< soon; smoothed when things have come to rest
  void redrawMoving();                    ///< the same while the camera or something under the mouse moves
  void redrawAtRest();                    ///< the same when nothing is going to move: it is smoothed at once
  void wantFrame() { next_.start(); }     ///< soon, if there is anything new to draw
  /// Paints the widget with what there is, drawn at once when there is nothing yet. To be called by its paint event.
  void paint();
  /// What is shown, drawn before when it is out of date.
  const QImage& upToDate();

  /// Every pixel and triangle is drawn, not every second one, and nothing is out of date.
  [[nodiscard]] bool detailed() const;
  /// All edges are smoothed, too.
  [[nodiscard]] bool sharp() const;
  [[nodiscard]] double scale() const { return scale_; }  ///< device pixels per pixel
  [[nodiscard]] double lastFrameMs() const { return lastFrameMs_; }
  [[nodiscard]] int framesDrawn() const { return framesDrawn_; }

 signals:
  void scaleChanged();
  void shown();    ///< a new frame is in the picture
  void painted();  ///< and on the screen

 private:
  [[nodiscard]] bool smooth() const { return smoothing_.complete() || (multisampled_ && smoothing_.taken() > 0); }
  void fitSize();
  void beginFrame();
  void comeToRest();
  void lookForFrame();
  void takeFrame();
  void chooseHaste();
  void showFrame(const std::vector<std::uint32_t>& pixels);
  void drawNow();
  void chooseSmoothing();
  void tellPainted();

  QWidget& widget_;
  PictureSubject& subject_;
  std::shared_ptr<Painter> painter_;
  QImage picture_;
  double scale_ = 1;
  double lastFrameMs_ = 0;
  Smoothing smoothing_;
  bool multisampled_ = false, tooSlow_ = false;  // for it
  QTimer settle_, next_, arrival_;
  std::optional<std::uint64_t> frame_;  // that is being drawn
  bool outdated_ = false;               // it is, before it is there
  bool blank_ = true;                   // nothing is in the picture yet
  QImage before_;                       // what is shown until then
  bool changed_ = false;                // the picture, since it was painted
  bool untold_ = false;                 // that it was painted
  enum class Haste { None, Coarse, Half };
  bool moving_ = false;
  Haste haste_ = Haste::None;       ///< of frames while something moves, where whole ones take too long
  Haste frameHaste_ = Haste::None;  ///< of the frame that is being drawn
  bool opened_ = false;             ///< something has been shown at rest
  QSize frameSize_;
  QElapsedTimer frameTimer_;
  int framesDrawn_ = 0;
};

}  // namespace blossom::ui

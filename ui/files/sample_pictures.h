#pragma once
#include <QObject>
#include <QPixmap>
#include <QProcess>
#include <QStringList>

namespace blossom::ui {

/// Small pictures of files, drawn by the command line program so that neither the window nor its graphics driver has to
/// wait, and stored in the user's cache folder until the file changes. A file that cannot be drawn has no picture.
class SamplePictures : public QObject {
  Q_OBJECT
 public:
  /// Size of all pictures in device pixels: twice the size shown on tiles.
  static constexpr QSize size{300, 168};
  /// Path of the picture of a file in its current state.
  [[nodiscard]] static QString cached(const QString& file);

  explicit SamplePictures(QObject* parent = nullptr);
  ~SamplePictures() override;
  /// Requests pictures; they are delivered by `ready`, cached ones at once.
  void request(const QStringList& files);
  /// Stops drawing until the next request.
  void stop();

 signals:
  void ready(const QString& file, const QPixmap&);

 private:
  void next();

  QStringList waiting_;
  QProcess drawing_;
};

}  // namespace blossom::ui

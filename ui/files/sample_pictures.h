#pragma once
#include <QObject>
#include <QPixmap>
#include <QProcess>
#include <QStringList>

namespace blossom::ui {

/// Small pictures of files, drawn by the command line program so that neither the window nor its graphics driver has to
/// wait, and kept in the user's cache folder until the file changes. A file that cannot be drawn has no picture.
class SamplePictures : public QObject {
  Q_OBJECT
 public:
  /// Of all pictures, in device pixels: twice the size that tiles show them at.
  static constexpr QSize size{300, 168};
  /// Where the picture of a file as it is now belongs.
  [[nodiscard]] static QString cached(const QString& file);

  explicit SamplePictures(QObject* parent = nullptr);
  ~SamplePictures() override;
  /// Pictures arrive by `ready`, those of the cache at once.
  void request(const QStringList& files);
  /// Draws no more; the rest is asked for again by the next request.
  void stop();

 signals:
  void ready(const QString& file, const QPixmap&);

 private:
  void next();

  QStringList waiting_;
  QProcess drawing_;
};

}  // namespace blossom::ui

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
  /// @param size of the pictures in device pixels
  explicit SamplePictures(QSize size, QObject* parent = nullptr);
  ~SamplePictures() override;
  /// Pictures arrive by `ready`, those of the cache at once.
  void request(const QStringList& files);
  /// Draws no more; the rest is asked for again by the next request.
  void stop();

 signals:
  void ready(const QString& file, const QPixmap&);

 private:
  void next();
  [[nodiscard]] QString cached(const QString& file) const;

  QSize size_;
  QStringList waiting_;
  QProcess drawing_;
};

}  // namespace blossom::ui

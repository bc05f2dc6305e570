#include "ui/files/document_picture.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include "core/error.h"
#include "scene/scene.h"
#include "ui/files/sample_pictures.h"
#include "ui/thread/background.h"

namespace blossom::ui {

namespace {

// Nobody waits at the end of the program for a picture.
const CancelToken& ending() {
  static const CancelToken token;
  static const auto connection = QObject::connect(qApp, &QCoreApplication::aboutToQuit, qApp, [] { token.cancel(); });
  Q_UNUSED(connection)
  return token;
}

}  // namespace

void keepPicture(std::vector<Shape> shapes, const QString& file) {
  if (shapes.empty()) return;
  static Background thread;
  const QString to = SamplePictures::cached(file);
  thread.start([shapes = std::move(shapes), to, token = ending()] {
    if (!QDir().mkpath(QFileInfo(to).path())) return;
    PictureOptions options;
    options.width = SamplePictures::size.width();
    options.height = SamplePictures::size.height();
    options.transparent = true;
    try {
      renderPicture(shapes, to.toStdString(), options, Progress(token));
    } catch (const Error& error) {
      if (error.code() != ErrorCode::Cancelled) qWarning("No picture was drawn: %s", error.what());
    }
  });
}

}  // namespace blossom::ui

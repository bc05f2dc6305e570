#include "ui/help/about_versions.h"

#include <vtkVersion.h>

#include <Eigen/Core>
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSysInfo>
#include <Standard_Version.hxx>
#include <boost/version.hpp>

#include "core/version.h"

namespace blossom::ui {

namespace {

// A context of its own: the view's may belong to another thread of drawing just now.
QString graphicsDriver() {
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  if (!context.create() || !context.makeCurrent(&surface)) return {};
  const auto text = [&](GLenum name) {
    const GLubyte* given = context.functions()->glGetString(name);
    return given ? QString::fromUtf8(reinterpret_cast<const char*>(given)) : QString();
  };
  QString driver = QStringLiteral("%1, OpenGL %2").arg(text(GL_RENDERER), text(GL_VERSION));
  context.doneCurrent();
  return driver;
}

}  // namespace

std::vector<LibraryVersion> libraryVersions() {
  std::vector<LibraryVersion> versions{
      {QStringLiteral("Blossom"), QLatin1String(versionText)},
      {QStringLiteral("Qt"), QLatin1String(qVersion())},
      {QStringLiteral("OpenCASCADE"), QStringLiteral(OCC_VERSION_COMPLETE)},
      {QStringLiteral("VTK"), QString::fromUtf8(vtkVersion::GetVTKVersion())},
      {QStringLiteral("Eigen"),
       QStringLiteral("%1.%2.%3").arg(EIGEN_WORLD_VERSION).arg(EIGEN_MAJOR_VERSION).arg(EIGEN_MINOR_VERSION)},
      {QStringLiteral("Boost"), QString::fromLatin1(BOOST_LIB_VERSION).replace(u'_', u'.')},
      {QStringLiteral("System"),
       QStringLiteral("%1, %2, %3")
           .arg(QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture(), QGuiApplication::platformName())}};
  const QString driver = graphicsDriver();
  if (!driver.isEmpty()) versions.push_back({QStringLiteral("Graphics"), driver});
  return versions;
}

QString asText(const std::vector<LibraryVersion>& versions) {
  QString text;
  for (const LibraryVersion& each : versions) text += QStringLiteral("%1: %2\n").arg(each.name, each.version);
  return text;
}

}  // namespace blossom::ui

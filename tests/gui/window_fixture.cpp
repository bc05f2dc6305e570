#include "window_fixture.h"

#include <QAbstractButton>
#include <QDragEnterEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <limits>

namespace blossom::ui {

void WindowFixture::setUpOnce() {
  setUpApplication();
  keepShaders();
  for (const char* name : {"XDG_CACHE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"})
    qputenv(name, folder_.path().toLocal8Bit());
  if (qEnvironmentVariableIsEmpty("BLOSSOM_WORKER"))
    qputenv("BLOSSOM_WORKER", (test::buildFolder() / "bin/blossom-worker").c_str());
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
  ThemeManager::instance().apply(ThemeChoice::Dark);
}

void WindowFixture::openWindow(const std::vector<std::filesystem::path>& plugins) {
  window_ = std::make_unique<MainWindow>(loadApp(plugins));
  window_->resize(1000, 700);
  window_->show();
  window_->activateWindow();  // no window manager does it; shortcuts need it
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  QVERIFY2(window_->view().problem().isEmpty(), qPrintable(window_->view().problem()));
  QCoreApplication::processEvents();  // what the window does once it is there
}

void WindowFixture::openNewDocument() {
  openWindow();
  run("file.new");
}

FeatureId WindowFixture::add(const char* type, const Value& parameters, std::vector<FeatureId> inputs) {
  const Document document = window_->page().document();
  Feature feature;
  feature.type = type;
  feature.id = feature.name = document.freshId(window_->page().registry().at(type)->command);
  feature.parameters = parameters;
  feature.inputs = std::move(inputs);
  window_->session().commit(document.with(feature), QStringLiteral("Add"));
  waitUntilComputed();
  QCoreApplication::sendPostedEvents();  // the first feature is selected, the panel filled in a turn of its own
  return feature.id;
}

void WindowFixture::keepShaders() {
  const QString caches = QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation);
  if (qEnvironmentVariableIsEmpty("MESA_SHADER_CACHE_DIR")) qputenv("MESA_SHADER_CACHE_DIR", caches.toLocal8Bit());
}

FeatureId WindowFixture::sweep() const {
  for (const auto& feature : window_->session().document().features())
    if (feature->type == "sweep.sweep") return feature->id;
  return {};
}

void WindowFixture::openAndWait(const QString& file) {
  window_->openFile(file);
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().document().features().empty() && !window_->session().evaluating() &&
                               !window_->session().job().running(),
                           300000);
  QVERIFY2(window_->errors().isHidden(), qPrintable(window_->errors().message()));
  QTRY_VERIFY(window_->view().sharp());
}

void WindowFixture::openPropeller() {
  openAndWait(propeller());
  QVERIFY(!sweep().empty());
}

void WindowFixture::waitUntilComputed() {
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().evaluating() && !window_->session().job().running(), 300000);
}

void WindowFixture::run(const char* command) {
  const Command* found = window_->commands().find(QLatin1String(command));
  QVERIFY2(found, command);
  found->action->trigger();
}

void WindowFixture::edit(const char* parameter, const char* typed) {
  ParameterField* const field = window_->properties().field(QLatin1String(parameter));
  QVERIFY2(field, parameter);
  auto* const line = field->findChild<QLineEdit*>();
  QVERIFY2(line, parameter);
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, QLatin1String(typed));
  QTest::keyClick(line, Qt::Key_Return);
}

double WindowFixture::measureOf(const FeatureId& id, const char* name) const {
  const auto view = window_->session().view(id);
  if (view)
    for (const Measure& measure : view->measures.values)
      if (measure.name == name) {
        if (const auto* number = std::get_if<double>(&measure.value)) return *number;
        if (const auto* count = std::get_if<std::int64_t>(&measure.value)) return static_cast<double>(*count);
      }
  return std::numeric_limits<double>::quiet_NaN();
}

void WindowFixture::mouseIn(QWidget* to, QEvent::Type type, const QPointF& at, Qt::KeyboardModifiers modifiers) {
  const bool moves = type == QEvent::MouseMove;
  held_ = type == QEvent::MouseButtonPress || (held_ && moves);
  QMouseEvent event(type, at, to->mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                    held_ ? Qt::LeftButton : Qt::NoButton, modifiers);
  QApplication::sendEvent(to, &event);
}

void WindowFixture::clickAt(const Vec3& p, Qt::KeyboardModifiers modifiers) {
  moveTo(p);
  QTest::mouseClick(&window_->view(), Qt::LeftButton, modifiers, screenOf(p));
}

void WindowFixture::answer(QMessageBox::StandardButton button, bool& asked) {
  QTimer::singleShot(0, window_.get(), [this, button, &asked] {
    auto* question = window_->findChild<QMessageBox*>();
    asked = question != nullptr;
    if (question) question->button(button)->click();
  });
}

bool WindowFixture::drop(const QStringList& files) {
  QMimeData data;
  QList<QUrl> urls;
  for (const QString& file : files) urls << QUrl::fromLocalFile(file);
  data.setUrls(urls);
  QDragEnterEvent enter(QPoint(500, 400), Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(window_.get(), &enter);
  if (!enter.isAccepted()) return false;
  QDropEvent event(QPointF(500, 400), Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(window_.get(), &event);
  return event.isAccepted();
}

void WindowFixture::exportAs(const char* format, const QString& file, const Value& options) {
  const QString saidBefore = window_->errors().message();
  run("file.export");
  const QPointer<ExportDialog> dialog = window_->findChild<ExportDialog*>();
  QVERIFY(dialog);
  dialog->choose(QLatin1String(format));
  QCOMPARE(dialog->format().id, std::string(format));
  for (auto* field : dialog->findChildren<ParameterField*>())
    if (options.contains(field->spec().name)) field->setValue(options.at(field->spec().name));
  QTimer answering;
  connect(&answering, &QTimer::timeout, &answering, [&] {
    auto* chooser = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (!chooser) return;
    answering.stop();
    auto* name = chooser->findChild<QLineEdit*>();
    name->setText(file);
    QTest::keyClick(name, Qt::Key_Return);
  });
  answering.start(20);
  dialog->accept();
  waitUntilComputed();
  const QString said = window_->errors().message();  // warnings of what is exported are repeated
  QVERIFY2(said == saidBefore || said.startsWith(QStringLiteral("The file was written")), qPrintable(said));
  QTRY_VERIFY(!dialog);  // the next one is found by its type
}

QImage WindowFixture::canvas() {
  if (!QTest::qWaitFor([this] { return window_->view().sharp(); })) qWarning("the view does not come to rest");
  return window_->view().grabFramebuffer().convertToFormat(QImage::Format_RGB32);
}

double WindowFixture::colored(const QImage& image, const QColor& color) {
  qint64 found = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor pixel = image.pixelColor(x, y);
      const int turn = std::abs(pixel.hsvHue() - color.hsvHue());
      if (pixel.hsvSaturation() > 90 && std::min(turn, 360 - turn) < 14) ++found;
    }
  return double(found) / (double(image.width()) * image.height());
}

}  // namespace blossom::ui

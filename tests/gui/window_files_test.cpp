#include <QPushButton>

#include "document/storage.h"
#include "ui/look/text.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

class WindowFilesTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }
  void savedAndOpenedAgainItIsTheSame();
  void aBrokenFileIsSaidInPlace();
  void aDamagedDocumentOffersWhatIsReadable();
  void exportedPictureIsAPicture();
  void whatAFileLosesIsSaid();
  void unsavedChangesAreAskedFor();
  void droppedFilesAreOpenedOrAdded();
};

void WindowFilesTest::savedAndOpenedAgainItIsTheSame() {
  openPropeller();
  const std::filesystem::path file = folder_.filePath(QStringLiteral("saved.blossom")).toStdString();
  DocumentTree& tree = window_->tree();
  tree.model()->setData(tree.currentIndex(), QStringLiteral("Blades"), Qt::EditRole);
  bool saved = false;
  window_->session().save(file, [&] { saved = true; });
  QTRY_VERIFY(saved);
  QVERIFY(!window_->isWindowModified());
  QVERIFY(window_->windowTitle().startsWith(QStringLiteral("saved.blossom")));
  const std::string written = toJson(window_->session().document());
  const auto area = [&] { return stateLine(window_->session().view(sweep())->measures); };
  QTRY_VERIFY(!window_->session().evaluating());
  const QString before = area();

  window_->session().clear();
  QVERIFY(window_->session().document().features().empty());
  QSignalSpy finished(&window_->session(), &Session::evaluationFinished);
  window_->openFile(qt(file.string()));
  QTRY_VERIFY_WITH_TIMEOUT(!sweep().empty() && !finished.isEmpty() && !window_->session().evaluating(), 60000);
  QCOMPARE(toJson(window_->session().document()), written);
  QCOMPARE(area(), before);
}

void WindowFilesTest::aBrokenFileIsSaidInPlace() {
  const QString file = folder_.filePath(QStringLiteral("broken.step"));
  QFile out(file);
  QVERIFY(out.open(QIODevice::WriteOnly));
  out.write("ISO-10303-21; nothing of the sort");
  out.close();
  window_->openFile(file);
  const auto failedFeature = [&] {
    for (const auto& feature : window_->session().document().features()) {
      const auto view = window_->session().view(feature->id);
      if (view && view->result->error) return true;
    }
    return false;
  };
  // Either the file is refused, or the import feature keeps the error.
  QTRY_VERIFY_WITH_TIMEOUT(window_->errors().isVisible() || failedFeature(), 60000);
  window_->openFile(folder_.filePath(QStringLiteral("not-there.step")));
  QTRY_VERIFY(window_->errors().isVisible());
  QVERIFY(!window_->errors().message().isEmpty());
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  QVERIFY(window_->errors().isHidden());
}

void WindowFilesTest::aDamagedDocumentOffersWhatIsReadable() {
  openPropeller();
  const QString file = folder_.filePath(QStringLiteral("damaged.blossom"));
  QFile out(file);
  QVERIFY(out.open(QIODevice::WriteOnly));
  out.write("PK\003\004 cut off");
  out.close();
  const std::string before = toJson(window_->session().document());
  window_->openFile(file);
  QCOMPARE(window_->pageCount(), std::size_t(2));  // the open document is left alone
  QTRY_VERIFY(window_->errors().isVisible());
  QCOMPARE(toJson(window_->page(0).document()), before);
  QVERIFY(window_->errors().findChild<QPushButton*>()->isVisible());
}

void WindowFilesTest::exportedPictureIsAPicture() {
  openPropeller();
  const QString file = folder_.filePath(QStringLiteral("propeller.png"));
  window_->session().exportFeature(sweep(), file.toStdString(), Value{{"size", "320x200"}});
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().job().running(), 60000);
  QVERIFY2(window_->errors().isHidden(), qPrintable(window_->errors().message()));
  QCOMPARE(QImage(file).size(), QSize(320, 200));
  // Drawing elsewhere has left the window's own context alone.
  QVERIFY(colored(canvas(), theme().color("made")) > 0.03);
}

/// A tetrahedron 10 km from the origin: single precision moves its corners by half a millimetre.
void WindowFilesTest::whatAFileLosesIsSaid() {
  const QString far = folder_.filePath(QStringLiteral("far.off"));
  QFile out(far);
  QVERIFY(out.open(QIODevice::WriteOnly));
  out.write("OFF\n4 4 0\n10000000 0 0\n10000010 0 0\n10000000 10 0\n10000000 0 10\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  out.close();
  window_->openFile(far);
  Session& session = window_->session();
  QTRY_VERIFY_WITH_TIMEOUT(!session.document().features().empty() && !session.evaluating(), 60000);
  QSignalSpy warned(&session, &Session::exportWarned);
  const QString file = folder_.filePath(QStringLiteral("far.stl"));
  session.exportFeatures({session.document().features().front()->id}, file.toStdString(), Value::object());
  QTRY_VERIFY(!warned.isEmpty());
  QVERIFY(warned.front().front().toStringList().front().contains(QStringLiteral("move by up to 1 mm")));
  QVERIFY(window_->errors().message().startsWith(QStringLiteral("The file was written")));
  QVERIFY(QFileInfo(file).size() == 84 + 4 * 50);
}

void WindowFilesTest::unsavedChangesAreAskedFor() {
  openPropeller();
  window_->tree().model()->setData(window_->tree().currentIndex(), QStringLiteral("Blades"), Qt::EditRole);
  const std::string before = toJson(window_->session().document());
  bool asked = false;
  answer(QMessageBox::Cancel, asked);
  QVERIFY(!window_->close());
  QVERIFY(asked && window_->isVisible());
  asked = false;
  answer(QMessageBox::Cancel, asked);
  window_->closePage(0);
  QVERIFY(asked);
  QCOMPARE(toJson(window_->session().document()), before);

  // Saved first: the file has the change, then the window closes.
  const QString file = folder_.filePath(QStringLiteral("guarded.blossom"));
  bool saved = false;
  window_->session().save(file.toStdString(), [&] { saved = true; });
  QTRY_VERIFY(saved);
  window_->tree().model()->setData(window_->tree().currentIndex(), QStringLiteral("Four blades"), Qt::EditRole);
  asked = false;
  answer(QMessageBox::Save, asked);
  window_->close();
  QVERIFY(asked);
  QTRY_VERIFY(!window_->isVisible());
  QCOMPARE(openDocument(file.toStdString()).document.at(sweep()).name, std::string("Four blades"));
}

void WindowFilesTest::droppedFilesAreOpenedOrAdded() {
  QVERIFY(!drop({}));
  QVERIFY(drop({propeller()}));
  QTRY_VERIFY_WITH_TIMEOUT(!sweep().empty() && !window_->session().evaluating(), 60000);
  const std::size_t count = window_->session().document().features().size();
  const QString drawing = folder_.filePath(QStringLiteral("drawing.svg"));
  QFile out(drawing);
  QVERIFY(out.open(QIODevice::WriteOnly));
  out.write("<svg xmlns='http://www.w3.org/2000/svg'><rect width='40' height='20'/></svg>");
  out.close();
  QVERIFY(drop({drawing}));
  QTRY_COMPARE_WITH_TIMEOUT(window_->session().document().features().size(), count + 1, 60000);
  QVERIFY(window_->session().modified());
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().evaluating(), 60000);
  window_->session().undo();
  QCOMPARE(window_->session().document().features().size(), count);
}

BLOSSOM_WINDOW_TEST(WindowFilesTest)
#include "window_files_test.moc"

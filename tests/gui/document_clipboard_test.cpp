#include "ui/tree/document_clipboard.h"

#include <QMimeData>

#include "tree_fixture.h"

using namespace blossom;
using namespace blossom::ui;

class DocumentClipboardTest : public TreeFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openChain(); }
  void cleanup() { closeTestWindow(); }

  void duplicatedWithTheSameInputs();
  void pastedIntoAnotherDocument();
  void pastedFromText();
};

void DocumentClipboardTest::duplicatedWithTheSameInputs() {
  choose({"b", "d"});
  trigger("edit.duplicate");
  QCOMPARE(order().size(), std::size_t(6));
  QCOMPARE(undoText(), QStringLiteral("Duplicate 2 features"));
  const std::vector<FeatureId> copies = window_->tree().selected();
  QCOMPARE(copies.size(), std::size_t(2));
  QCOMPARE(document().at(copies[0]).inputs, std::vector<FeatureId>{"a"});
  QCOMPARE(document().at(copies[1]).inputs, (std::vector<FeatureId>{copies[0], "c"}));
  QCOMPARE(document().at(copies[0]).name, std::string("b 2"));
  undo();
  QCOMPARE(order(), (std::vector<FeatureId>{"a", "b", "c", "d"}));
}

void DocumentClipboardTest::pastedIntoAnotherDocument() {
  choose({"b"});
  trigger("edit.copy");
  trigger("edit.paste");
  QCOMPARE(order().size(), std::size_t(5));  // made from the "a" that is there
  undo();
  window_->addPage();
  trigger("edit.paste");
  QCOMPARE(order(), (std::vector<FeatureId>{"a", "b"}));
  QCOMPARE(document().at("b").inputs, std::vector<FeatureId>{"a"});
  undo();
  QVERIFY(order().empty());
}

// Another program sees text; what comes from one is checked.
void DocumentClipboardTest::pastedFromText() {
  const auto content = std::make_shared<const std::string>("solid nothing");
  Feature file = feature("file", "exchange.import");
  file.parameters = {{"file", {{"asset", contentHash(*content)}, {"name", "nothing.stl"}}}};
  const Document source = Document::of({file}).withAsset(contentHash(*content), content);
  const std::unique_ptr<QMimeData> own(toMimeData({source, {"file"}}));
  QMimeData foreign;
  for (const QString& format : own->formats()) foreign.setData(format, own->data(format));
  QVERIFY(own->text().contains(QStringLiteral("exchange.import")));
  const auto read = fromMimeData(&foreign);
  QVERIFY(read);
  QCOMPARE(read->wanted, std::vector<FeatureId>{"file"});
  QCOMPARE(read->document.at("file").parameters, file.parameters);
  QCOMPARE(*read->document.assets().at(contentHash(*content)), *content);
  QMimeData damaged;
  damaged.setData(own->formats().front(), "{\"blossom\": 1, \"features\": [");
  VERIFY_ERROR(fromMimeData(&damaged), ErrorCode::FormatDamaged);
}

BLOSSOM_WINDOW_TEST(DocumentClipboardTest)
#include "document_clipboard_test.moc"

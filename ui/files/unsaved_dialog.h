#pragma once
#include <QDialog>
#include <QString>
#include <vector>

class QCheckBox;
class QPushButton;

namespace blossom::ui {

/// As a list of documents tells it from the others.
struct UnsavedDocument {
  QString name;
  bool wanted = true;  ///< to be saved, unless the user says otherwise
};

/// What shall become of several documents with unsaved changes, asked once.
class UnsavedDialog : public QDialog {
  Q_OBJECT
 public:
  enum class Answer { Save, Discard, Cancel };
  explicit UnsavedDialog(const std::vector<UnsavedDocument>& documents, QWidget* parent = nullptr);
  [[nodiscard]] Answer answer() const { return answer_; }
  [[nodiscard]] std::vector<std::size_t> chosen() const;  ///< places of those to be saved

 private:
  void refresh();
  void finish(Answer);
  std::vector<QCheckBox*> boxes_;
  QPushButton* save_;
  Answer answer_ = Answer::Cancel;
};

}  // namespace blossom::ui

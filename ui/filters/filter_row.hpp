// One step of the pipeline in the filter list.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCheckBox>
#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <optional>
#include <vector>

#include "ui/base/widgets/number_field.hpp"
#include "ui/document/document.hpp"
#include "ui/run/step_status.hpp"
#include "ui/run/time_strip.hpp"

namespace footfall::ui {

/// Shows an entry and its status. It emits a signal for each action of the user and changes nothing itself. A collapsed
/// row is one line with its values as text; an expanded row also has their fields.
class FilterRow : public QFrame {
  Q_OBJECT

 public:
  explicit FilterRow(const FilterEntry& entry, QWidget* parent = nullptr);

  [[nodiscard]] int entryId() const { return id_; }
  /// Returns whether the row has the fields that an entry needs: a step with repeated values may have more or fewer of
  /// them.
  [[nodiscard]] bool fits(const FilterEntry& entry) const;
  /// Sets other values of the same filter; they must fit.
  void setEntry(const FilterEntry& entry);
  void setStatus(const StepStatus& status);
  /// Marks the rows of a parallel block, from its strategy to its Collapse.
  void setInBlock(bool inBlock);
  void setSelected(bool selected);
  /// A row with a field whose text is no valid value stays open.
  void setOpen(bool open);
  [[nodiscard]] bool isOpen() const { return open_; }
  /// The step's share of the total time; empty where it has no time.
  void setShare(std::optional<double> share, const QColor& colour);
  void setUnits(const LevelUnits& units);

  /// The part of the row that starts a drag.
  [[nodiscard]] QWidget* handle() const { return handle_; }
  /// The NumberField or QCheckBox of a value.
  [[nodiscard]] QWidget* field(std::size_t value) const { return fields_[value]; }
  /// The number of fields. A filter with very many values has fields for the first ones only.
  [[nodiscard]] std::size_t fieldCount() const { return fields_.size(); }
  /// The button that places seeds; null for filters without seeds.
  [[nodiscard]] QToolButton* placeButton() const { return place_; }
  /// The button that removes the seed `group`.
  [[nodiscard]] QToolButton* removeGroupButton(std::size_t group) const { return removeGroup_[group]; }
  [[nodiscard]] QCheckBox* enabledBox() const { return enabled_; }
  [[nodiscard]] QLabel* nameLabel() const { return name_; }
  /// The values of a collapsed row, e.g. "45°".
  [[nodiscard]] QString summaryText() const { return summary_->text(); }
  /// The button of a skipped row that enables or adds Vertical clearance.
  [[nodiscard]] QToolButton* mendButton() const { return mend_; }
  /// Sets whether the Vertical clearance filter that a skipped row needs exists and is disabled; otherwise there is
  /// none.
  void setClearanceOff(bool off);
  [[nodiscard]] QToolButton* removeButton() const { return remove_; }
  /// The button that shows the cells; null for filters that are no strategy.
  [[nodiscard]] QToolButton* previewButton() const { return preview_; }
  /// The unit behind the field of a number, e.g. "degrees".
  [[nodiscard]] QString unitOf(std::size_t parameter) const { return units_[parameter]->text(); }
  [[nodiscard]] const ShareBar& shareBar() const { return *share_; }
  [[nodiscard]] QString figuresText() const { return figures_->text(); }
  [[nodiscard]] QString stateText() const { return state_->text(); }
  [[nodiscard]] QString errorText() const { return error_->text(); }

 signals:
  void enabledEdited(int id, bool enabled);
  void valueEdited(int id, std::size_t parameter, double value, int editSession);
  void removeRequested(int id);
  /// Emitted when the user chooses to get the Vertical clearance filter that the row needs.
  void clearanceRequested(int id);
  /// Emitted by strategies only.
  void previewRequested(int id);
  /// Emitted when the user begins or ends placing seeds in the view.
  void placingRequested(int id, bool on);
  void groupRemoved(int id, std::size_t group);
  /// Emitted when the drag of a value begins or ends.
  void draggingChanged(bool dragging);
  /// Emitted when the mouse enters or leaves a value or its name.
  void parameterPointed(int id, std::size_t parameter, bool on);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addParameters(QVBoxLayout* layout);
  void addGroups(QVBoxLayout* layout, std::size_t values);
  NumberField* makeNumber(const ParameterDescriptor& parameter, std::size_t index, QWidget* parent);
  void addNumber(const ParameterDescriptor& parameter, std::size_t index, QGridLayout* grid, QLabel* label);
  void addHead(QVBoxLayout* layout);
  void showUnits();
  void showSummary();
  void showParts();
  void showState();
  void showError();

  int id_;
  const FilterDescriptor& filter_;
  QLabel* handle_;
  QCheckBox* enabled_;
  QLabel* name_ = nullptr;
  QLabel* summary_ = nullptr;
  QLabel* time_ = nullptr;
  QToolButton* mend_ = nullptr;
  bool open_ = false;
  std::vector<double> values_;
  QLabel* stateIcon_;
  QLabel* state_ = nullptr;
  QColor stateColour_;
  QToolButton* preview_ = nullptr;
  QToolButton* remove_;
  QToolButton* place_ = nullptr;
  std::vector<QToolButton*> removeGroup_;
  QLabel* groupUnit_ = nullptr;
  QLabel* moreGroups_ = nullptr;
  std::vector<QWidget*> fields_;
  std::vector<QLabel*> names_;  ///< names of the first fields, which do not repeat
  std::vector<QLabel*> units_;  ///< null for booleans and for groups, which share one unit
  LevelUnits shown_;
  QWidget* parameters_ = nullptr;
  QWidget* groups_ = nullptr;
  QLabel* figures_;
  QLabel* error_;
  ShareBar* share_;
  StepStatus status_;
};

}  // namespace footfall::ui

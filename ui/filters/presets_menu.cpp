// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/filters/presets_menu.hpp"

#include <QInputDialog>
#include <exception>
#include <utility>

#include "ui/base/text/core_text.hpp"

namespace footfall::ui {

PresetsMenu::PresetsMenu(Document& document, PresetStore store, QWidget* parent)
    : QMenu(parent), document_(document), store_(std::move(store)) {
  setObjectName(QStringLiteral("presetsMenu"));
  setToolTipsVisible(true);
  connect(this, &QMenu::aboutToShow, this, &PresetsMenu::fill);
  fill();
}

void PresetsMenu::guarded(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    emit failed(coreText(error));
  }
}

void PresetsMenu::fill() {
  for (QAction* action : actions()) {
    if (QMenu* menu = action->menu()) menu->deleteLater();
  }
  clear();
  addSection(tr("Built in"));
  for (const BuiltInPreset& preset : builtInPresets()) {
    QAction* action = addAction(preset.name, this, [this, preset] {
      guarded([&] {
        document_.replacePipeline(builtInPipeline(preset, metresPerUnit_), tr("Use preset %1").arg(preset.name));
      });
    });
    action->setToolTip(preset.help);
    action->setData(preset.name);
  }
  const QStringList own = store_.names();
  addSection(tr("Your own"));
  // An ampersand in a name must not become a mnemonic.
  const auto shown = [](QString name) { return name.replace(QLatin1Char('&'), QLatin1String("&&")); };
  for (const QString& name : own) {
    QAction* action = addAction(shown(name), this, [this, name] {
      guarded([&] { document_.replacePipeline(store_.read(name), tr("Use preset %1").arg(name)); });
    });
    action->setToolTip(store_.pathOf(name));
    action->setData(name);
  }
  addAction(tr("&Save as preset..."), this, &PresetsMenu::saveAs)->setObjectName(QStringLiteral("savePreset"));
  if (own.isEmpty()) return;
  QMenu* renaming = addMenu(tr("&Rename preset"));
  QMenu* deleting = addMenu(tr("&Delete preset"));
  renaming->setObjectName(QStringLiteral("renamePreset"));
  deleting->setObjectName(QStringLiteral("deletePreset"));
  for (const QString& name : own) {
    renaming->addAction(shown(name), this, [this, name] {
      askForName(tr("Rename the preset"), name, [this, name](const QString& to) {
        if (to != name) store_.rename(name, to);
      });
    });
    deleting->addAction(shown(name), this, [this, name] { remove(name); });
  }
}

void PresetsMenu::saveAs() {
  askForName(tr("Save the filters as a preset"), {}, [this](const QString& name) {
    const bool there = store_.names().contains(name);
    const QByteArray before = there ? store_.remove(name) : QByteArray();
    store_.save(name, document_.pipeline());
    const auto undo = [this, name, before, there] {
      guarded([&] {
        store_.remove(name);
        if (there) store_.restore(name, before);
      });
    };
    emit done(there ? tr("The preset '%1' was replaced.").arg(name) : tr("Saved as preset '%1'.").arg(name), tr("Undo"),
              undo);
  });
}

// Removes without a question, because it can be undone.
void PresetsMenu::remove(const QString& name) {
  guarded([&] {
    const QByteArray content = store_.remove(name);
    emit done(tr("The preset '%1' was deleted.").arg(name), tr("Undo"),
              [this, name, content] { guarded([&] { store_.restore(name, content); }); });
  });
}

void PresetsMenu::askForName(const QString& title, const QString& suggested,
                             const std::function<void(const QString&)>& use) {
  auto* dialog = new QInputDialog(parentWidget());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setObjectName(QStringLiteral("presetName"));
  dialog->setWindowTitle(title);
  dialog->setLabelText(tr("Name:"));
  dialog->setTextValue(suggested);
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this, use](const QString& name) { guarded([&] { use(name.trimmed()); }); });
  dialog->open();
}

}  // namespace footfall::ui

#include "workspace/last_state.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

#include "relief/errors.h"
#include "workspace/language.h"
#include "workspace/pane_store.h"

namespace reliefui {

// Called before there is a QApplication that provides the program's name.
QString settingsFolder() {
    const QString name = QStringLiteral("reliefscope");
    const QSettings settings(QSettings::NativeFormat, QSettings::UserScope, name, name);
    return QFileInfo(settings.fileName()).path();
}

QString lastStateFile() {
    return settingsFolder() + QStringLiteral("/last.json");
}

std::optional<relief::Scenario> lastState(relief::AssetStore& store, const StateReaders& readers) {
    const QString path = lastStateFile();
    if (!QFileInfo::exists(path)) return std::nullopt;
    try {
        const relief::Scenario scenario = loadWindowScenario(path.toStdString(), readers);
        relief::AssetStore pictures;
        relief::Work work;
        pictures.load(scenario.pictures, work, true);
        store = std::move(pictures);
        return scenario;
    } catch (const relief::InputError&) {
        return std::nullopt;
    }
}

std::string keepState(const relief::Scenario& scenario) {
    QDir().mkpath(settingsFolder());
    try {
        relief::saveScenario(lastStateFile().toStdString(), scenario);
        return {};
    } catch (const relief::InputError& error) {
        return error.text(uiLanguage());
    }
}

}  // namespace reliefui

#include "workspace/last_state.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

#include "errors.h"

namespace reliefui {

namespace {

// The program asks before there is an application that knows its name.
QString lastPath() {
    const QString name = QStringLiteral("reliefscope");
    const QSettings settings(QSettings::NativeFormat, QSettings::UserScope, name, name);
    return QFileInfo(settings.fileName()).path() + QStringLiteral("/last.json");
}

}  // namespace

std::optional<relief::Scenario> lastState(relief::AssetStore& store) {
    const QString path = lastPath();
    if (!QFileInfo::exists(path)) return std::nullopt;
    try {
        const relief::Scenario scenario = relief::loadScenario(path.toStdString());
        relief::AssetStore pictures;
        relief::Work work;
        pictures.load(scenario.pictures, work);
        store = std::move(pictures);
        return scenario;
    } catch (const relief::InputError&) {
        return std::nullopt;
    }
}

void keepState(const relief::Scenario& scenario) {
    const QString path = lastPath();
    if (!QDir().mkpath(QFileInfo(path).path())) return;
    try {
        relief::saveScenario(path.toStdString(), scenario);
    } catch (const relief::InputError&) {
        // Another start than this one is no harm.
    }
}

}  // namespace reliefui

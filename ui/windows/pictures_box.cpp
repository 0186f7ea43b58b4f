#include "windows/pictures_box.h"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSpinBox>
#include <QToolButton>

#include "panes/core_texts.h"
#include "panes/file_dialogs.h"
#include "relief/reliefs.h"
#include "windows/method_list.h"
#include "windows/seed_box.h"
#include "workspace/change_name.h"

namespace reliefui {

namespace {

constexpr int kLargestRecipe = 4096;  // a scenario's file may have a larger one

}  // namespace

QString askForPicture(QWidget* parent, const QString& title, const QString& current) {
    const QString filter = PicturesBox::tr("Pictures") +
                           QStringLiteral(" (*.png *.jpg *.jpeg *.tif *.tiff *.exr *.hdr *.bmp *.tga *.pgm *.ppm);;") +
                           PicturesBox::tr("All files") + QStringLiteral(" (*)");
    const QString folder = current.isEmpty() ? QString() : QFileInfo(current).absolutePath();
    return askOpenFile(parent, QStringLiteral("pictures"), title, filter, folder);
}

PicturesBox::PicturesBox(Workspace* workspace, QWidget* parent) : QWidget(parent), workspace_(workspace) {
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    folder_ = new QLabel(this);
    folder_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    column->addWidget(folder_);
    addRow(column, QT_TR_NOOP("Heights"), &relief::Pictures::height, QStringLiteral("height"));
    addRow(column, QT_TR_NOOP("Colour"), &relief::Pictures::color, QStringLiteral("color"));
    addRow(column, QT_TR_NOOP("Normals"), &relief::Pictures::normal, QStringLiteral("normal"));
    addRecipe(column);
    connect(workspace_, &Workspace::scenarioChanged, this, &PicturesBox::refresh);
    refresh();
}

void PicturesBox::addRow(QVBoxLayout* column, const char* source, std::string relief::Pictures::*member,
                         const QString& objectName) {
    const QString title = tr(source);
    auto* const line = new QHBoxLayout;
    auto* const label = new QLabel(title, this);
    label->setMinimumWidth(fontMetrics().horizontalAdvance(tr("Normals")) + 8);
    label->setContentsMargins(0, 0, 8, 0);  // needed in large type as well
    Row row;
    row.member = member;
    row.name = new QLabel(this);
    row.name->setMinimumWidth(40);
    row.name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* const open = new QToolButton(this);
    open->setText(tr("Open…"));
    open->setObjectName(QStringLiteral("open-") + objectName);
    open->setAccessibleName(tr("Open %1").arg(title));
    open->setToolTip(tr("Choose a picture file"));
    line->addWidget(label);
    line->addWidget(row.name, 1);
    line->addWidget(open);
    const bool isHeight = member == &relief::Pictures::height;
    if (!isHeight) {
        row.clear = new QToolButton(this);
        row.clear->setText(tr("None"));
        row.clear->setAccessibleName(tr("No %1").arg(title));
        row.clear->setToolTip(tr("Use no picture here"));
        line->addWidget(row.clear);
    }
    column->addLayout(line);
    const auto replace = [this, member, source](const std::string& path) {
        relief::Scenario scenario = workspace_->scenario();
        scenario.pictures.*member = path;
        workspace_->change(scenario, changeName([source] { return tr(source); }));
    };
    connect(open, &QToolButton::clicked, this, [this, member, title, isHeight, replace] {
        const QString path =
            askForPicture(this, title, QString::fromStdString(workspace_->scenario().pictures.*member));
        if (path.isEmpty()) return;
        if (isHeight) {
            workspace_->open(path);
        } else {
            replace(path.toStdString());
        }
    });
    if (row.clear != nullptr) connect(row.clear, &QToolButton::clicked, this, [replace] { replace({}); });
    rows_.push_back(row);
}

void PicturesBox::addRecipe(QVBoxLayout* column) {
    auto* const line = new QHBoxLayout;
    recipe_ = new QComboBox(this);
    recipe_->setObjectName(QStringLiteral("recipe"));
    recipe_->setAccessibleName(tr("Procedural relief"));
    recipe_->setToolTip(tr("Make a procedural relief instead of reading a picture"));
    recipe_->addItem(tr("Procedural…"), QString());
    addRecipes(recipe_);
    // Its titles must not make the panel wider.
    recipe_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    recipe_->setMinimumContentsLength(8);
    size_ = new QSpinBox(this);
    size_->setObjectName(QStringLiteral("recipe-size"));
    size_->setAccessibleName(tr("Size of the procedural relief"));
    size_->setToolTip(tr("Width in texels; the height keeps its ratio to it"));
    size_->setRange(1, kLargestRecipe);
    size_->setSingleStep(64);
    size_->setValue(256);
    size_->setLocale(QLocale::c());
    size_->setKeyboardTracking(false);
    seed_ = new SeedBox(this);
    seed_->setObjectName(QStringLiteral("recipe-seed"));
    seed_->setAccessibleName(tr("Seed of the procedural relief"));
    seed_->setToolTip(tr("Seed: each number gives another relief"));
    seed_->setValue(1);
    line->addWidget(recipe_, 1);
    line->addWidget(size_);
    line->addWidget(seed_);
    column->addLayout(line);
    connect(recipe_, qOverload<int>(&QComboBox::activated), this, [this](int) { makeRecipe(); });
    connect(size_, qOverload<int>(&QSpinBox::valueChanged), this, &PicturesBox::makeRecipe);
    connect(seed_, &SeedBox::edited, this, &PicturesBox::makeRecipe);
}

void PicturesBox::makeRecipe() {
    const std::string name = recipe_->currentData().toString().toStdString();
    if (name.empty()) return;
    relief::Scenario scenario = workspace_->scenario();
    relief::Pictures& pictures = scenario.pictures;
    if (pictures.recipe != name) {
        // Colours and normals of another relief would not match this one.
        pictures = {};
        pictures.recipe = name;
        pictures.recipeWidth = pictures.recipeHeight = relief::findRecipe(name, {}).defaultSize;
    } else if (size_->value() != pictures.recipeWidth) {
        // The box shows the width; the height keeps its ratio to it.
        const double height = static_cast<double>(size_->value()) * pictures.recipeHeight / pictures.recipeWidth;
        pictures.recipeHeight = std::max(1, static_cast<int>(std::lround(height)));
        pictures.recipeWidth = size_->value();
    }
    pictures.seed = seed_->value();
    workspace_->change(scenario, changeName([] { return tr("Procedural relief"); }));
}

void PicturesBox::refresh() {
    const relief::Pictures& pictures = workspace_->scenario().pictures;
    const bool procedural = pictures.height.empty();
    const QFileInfo heights(QString::fromStdString(pictures.height));
    folder_->setText(!pictures.drawn.empty() ? tr("relief drawn by hand")
                     : procedural            ? tr("procedural relief")
                                             : heights.dir().dirName());
    folder_->setToolTip(procedural ? QString() : heights.absolutePath());
    for (const Row& row : rows_) {
        const QFileInfo file(QString::fromStdString(pictures.*row.member));
        const QString folder = file.dir().dirName();
        const bool none = (pictures.*row.member).empty();
        row.name->setText(none ? tr("none") : file.fileName());
        row.name->setEnabled(!none);
        row.name->setToolTip(none ? QString() : folder + '/' + file.fileName());
        if (row.clear != nullptr) row.clear->setEnabled(!none);
    }
    const int found = recipe_->findData(QString::fromStdString(pictures.recipe));
    recipe_->setCurrentIndex(pictures.recipe.empty() ? 0 : found);
    const QSignalBlocker quiet(size_);
    if (pictures.recipe.empty()) return;
    size_->setMaximum(std::max(kLargestRecipe, pictures.recipeWidth));
    size_->setValue(pictures.recipeWidth);
    seed_->setValue(pictures.seed);
}

}  // namespace reliefui

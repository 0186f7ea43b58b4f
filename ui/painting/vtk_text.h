// Text in VTK pictures. VTK's own font drops Cyrillic silently, so every text property is made here.
#pragma once

#include <string>

#include <vtkSmartPointer.h>
#include <vtkTextProperty.h>

#include "painting/style.h"

namespace reliefui {

// DejaVuSans.ttf where the system keeps it; empty if it is not installed.
const std::string& fontFile();

// pixels: size of the text; the render window's dots per inch are taken to be VTK's 72.
void setText(vtkTextProperty* property, Rgba color, double pixels);
vtkSmartPointer<vtkTextProperty> makeText(Rgba color, double pixels);

}  // namespace reliefui

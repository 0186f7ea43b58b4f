// Text in VTK renderings. VTK's built-in font silently omits Cyrillic letters, so every text property is set up here.
#pragma once

#include <string>

#include <vtkSmartPointer.h>
#include <vtkTextProperty.h>

#include "painting/style.h"

namespace reliefui {

// Path of DejaVuSans.ttf on this system; empty if it is not installed.
const std::string& fontFile();

// Sets font, colour and size. pixels: text size; the render window's resolution is taken to be VTK's default, 72 dpi.
void setText(vtkTextProperty* property, Rgba color, double pixels);
vtkSmartPointer<vtkTextProperty> makeText(Rgba color, double pixels);

}  // namespace reliefui

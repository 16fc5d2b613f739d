//VTK::System::Dec

// Volumes leave their trace in the stencil buffer only.
void main()
{
}

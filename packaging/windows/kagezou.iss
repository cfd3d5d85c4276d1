; The installer for Windows, of the folder that packaging/bundle.py makes: ISCC /DVersion=0.1.0 packaging\windows\kagezou.iss
#ifndef Version
  #error Give the version: ISCC /DVersion=0.1.0 packaging\windows\kagezou.iss
#endif
#define Folder "..\..\build\bundle\dist\kagezou"

[Setup]
AppId={{6E1E7A9B-6C39-4B0E-9D2F-2B5C0C3C8A41}
AppName=Kagezou
AppVersion={#Version}
AppPublisher=Kagezou
DefaultDirName={autopf}\Kagezou
DefaultGroupName=Kagezou
PrivilegesRequired=lowest
PrivilegesRequiredOverridesAllowed=dialog
ArchitecturesAllowed=x64compatible
ArchitecturesInstallIn64BitMode=x64compatible
MinVersion=10.0.17763
OutputDir=..\..\build\bundle\packed
OutputBaseFilename=kagezou-{#Version}-windows-x86_64-setup
SetupIconFile=..\..\build\kagezou.ico
UninstallDisplayIcon={app}\kagezou-window.exe
LicenseFile=..\..\LICENSE
Compression=lzma2/max
SolidCompression=yes
ChangesAssociations=yes
ChangesEnvironment=yes
WizardStyle=modern

[Languages]
Name: "en"; MessagesFile: "compiler:Default.isl"
Name: "ja"; MessagesFile: "compiler:Languages\Japanese.isl"

[CustomMessages]
en.Associate=Open projects (.kage) with Kagezou
ja.Associate=プロジェクト（.kage）を Kagezou で開く
en.Path=Find the command kagezou in terminals
ja.Path=ターミナルで kagezou コマンドを使えるようにする
en.Software=Draw with the processor (for machines without a graphics driver)
en.PanelProblem=%1: cannot be written, so the panel for After Effects has to be told where Kagezou is (Program...).
ja.PanelProblem=%1 に書き込めないため、After Effects のパネルの「プログラム...」で Kagezou の場所を指定してください。
ja.Software=プロセッサーで描画する（グラフィックスドライバーのないマシン用）

[Tasks]
Name: "associate"; Description: "{cm:Associate}"
Name: "path"; Description: "{cm:Path}"
Name: "software"; Description: "{cm:Software}"; Flags: unchecked; Check: HasMesa
Name: "desktopicon"; Description: "{cm:CreateDesktopIcon}"; Flags: unchecked

[Files]
Source: "{#Folder}\*"; DestDir: "{app}"; Flags: recursesubdirs ignoreversion
; Mesa's own OpenGL, where packaging/bundle_mesa.py has fetched it: beside the program it is taken instead of the driver's.
Source: "{#Folder}\mesa\opengl32.dll"; DestDir: "{app}"; Tasks: software; Flags: skipifsourcedoesntexist ignoreversion
Source: "{#Folder}\mesa\libgallium_wgl.dll"; DestDir: "{app}"; Tasks: software; Flags: skipifsourcedoesntexist ignoreversion

[Icons]
Name: "{group}\Kagezou"; Filename: "{app}\kagezou-window.exe"
Name: "{autodesktop}\Kagezou"; Filename: "{app}\kagezou-window.exe"; Tasks: desktopicon

[Registry]
Root: HKA; Subkey: "Software\Classes\.kage"; ValueType: string; ValueData: "Kagezou.Project"; Flags: uninsdeletevalue; Tasks: associate
Root: HKA; Subkey: "Software\Classes\Kagezou.Project"; ValueType: string; ValueData: "Kagezou project"; Flags: uninsdeletekey; Tasks: associate
Root: HKA; Subkey: "Software\Classes\Kagezou.Project\DefaultIcon"; ValueType: string; ValueData: "{app}\kagezou-window.exe,0"; Tasks: associate
Root: HKA; Subkey: "Software\Classes\Kagezou.Project\shell\open\command"; ValueType: string; ValueData: """{app}\kagezou-window.exe"" ""%1"""; Tasks: associate
Root: HKCU; Subkey: "Environment"; ValueType: expandsz; ValueName: "Path"; ValueData: "{olddata};{app}"; Tasks: path; Check: IsNotOnPath

[UninstallDelete]
Type: files; Name: "{autoappdata}\Kagezou\program.txt"
Type: dirifempty; Name: "{autoappdata}\Kagezou"

[Run]
Filename: "{app}\kagezou-window.exe"; Description: "{cm:LaunchProgram,Kagezou}"; Flags: nowait postinstall skipifsilent

[Code]
function HasMesa(): Boolean;
begin
  Result := {#FileExists(AddBackslash(SourcePath) + Folder + "\mesa\opengl32.dll") ? "True" : "False"};
end;

function IsNotOnPath(): Boolean;
var
  Known: String;
begin
  if not RegQueryStringValue(HKCU, 'Environment', 'Path', Known) then
    Known := '';
  Result := Pos(';' + Uppercase(ExpandConstant('{app}')) + ';', ';' + Uppercase(Known) + ';') = 0;
end;

// Where the panel for After Effects looks for the program: Folder.userData, or Folder.appData where it is for all users.
procedure CurStepChanged(CurStep: TSetupStep);
var
  Folder: String;
  Lines: TArrayOfString;
begin
  if CurStep = ssPostInstall then
  begin
    Folder := ExpandConstant('{autoappdata}\Kagezou');
    SetArrayLength(Lines, 1);
    Lines[0] := ExpandConstant('{app}\kagezou.exe');
    if not (ForceDirectories(Folder) and SaveStringsToUTF8File(Folder + '\program.txt', Lines, False)) then
      SuppressibleMsgBox(FmtMessage(CustomMessage('PanelProblem'), [Folder]), mbInformation, MB_OK, IDOK);
  end;
end;

procedure CurUninstallStepChanged(Step: TUninstallStep);
var
  Known: String;
begin
  if (Step = usPostUninstall) and RegQueryStringValue(HKCU, 'Environment', 'Path', Known) then
  begin
    StringChangeEx(Known, ';' + ExpandConstant('{app}'), '', True);
    RegWriteExpandStringValue(HKCU, 'Environment', 'Path', Known);
  end;
end;

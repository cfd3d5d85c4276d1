<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>Application</name>
    <message>
        <source>“%1” was saved after this work began from it. Saving asks which of them stays.</source>
        <translation>「%1」は、この作業が始まった後に保存されています。保存するときに、どちらを残すか確認します。</translation>
    </message>
</context>
<context>
    <name>Asking</name>
    <message>
        <source>the files</source>
        <translation>ファイル</translation>
    </message>
</context>
<context>
    <name>Autosave</name>
    <message>
        <source>Unsaved work is put aside in %1 for now: %2</source>
        <translation>未保存の作業を、当面は %1 に退避しています：%2</translation>
    </message>
    <message>
        <source>Unsaved work cannot be put aside (%1). It is tried again; save your project meanwhile.</source>
        <translation>未保存の作業を退避できません(%1)。自動的に再試行します。その間にプロジェクトを保存してください。</translation>
    </message>
</context>
<context>
    <name>BoxDrag</name>
    <message>
        <source>Move keys</source>
        <translation>キーを移動</translation>
    </message>
    <message>
        <source>Stretch keys</source>
        <translation>キーを伸縮</translation>
    </message>
    <message>
        <source>Scale keys in value</source>
        <translation>キーの値を拡大縮小</translation>
    </message>
    <message>
        <source>Scale keys</source>
        <translation>キーを拡大縮小</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 フレーム</translation>
    </message>
    <message>
        <source>time × %1</source>
        <translation>時間 × %1</translation>
    </message>
    <message>
        <source>value × %1</source>
        <translation>値 × %1</translation>
    </message>
</context>
<context>
    <name>CanvasOffer</name>
    <message>
        <source>Cut Settings…</source>
        <translation>カット設定…</translation>
    </message>
    <message>
        <source>The picture gets the size of the background; drawings stay in the middle</source>
        <translation>画面を背景のサイズにします。セルは中央のままです</translation>
    </message>
    <message>
        <source>Choose what becomes of the drawings</source>
        <translation>セルの扱いを選ぶ</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>The background has %1 × %2 px, the picture %3 × %4.</source>
        <translation>背景は %1 × %2 px、画面は %3 × %4 です。</translation>
    </message>
    <message>
        <source>Use %1 × %2</source>
        <translation>%1 × %2 にする</translation>
    </message>
    <message>
        <source>Size of the background</source>
        <translation>背景のサイズに合わせる</translation>
    </message>
</context>
<context>
    <name>CanvasSizes</name>
    <message>
        <source>HD</source>
        <translation>HD</translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation>フルHD</translation>
    </message>
    <message>
        <source>2K cinema</source>
        <translation>2K シネマ</translation>
    </message>
    <message>
        <source>WQHD</source>
        <translation>WQHD</translation>
    </message>
    <message>
        <source>4K UHD</source>
        <translation>4K UHD</translation>
    </message>
    <message>
        <source>4K cinema</source>
        <translation>4K シネマ</translation>
    </message>
    <message>
        <source>B5 scan, 150 dpi</source>
        <translation>B5 スキャン 150 dpi</translation>
    </message>
    <message>
        <source>B5 scan, 200 dpi</source>
        <translation>B5 スキャン 200 dpi</translation>
    </message>
    <message>
        <source>A4 scan, 150 dpi</source>
        <translation>A4 スキャン 150 dpi</translation>
    </message>
    <message>
        <source>Upright HD</source>
        <translation>縦型 HD</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>正方形</translation>
    </message>
    <message>
        <source>The drawings</source>
        <translation>セルのサイズ</translation>
    </message>
    <message>
        <source>The background</source>
        <translation>背景のサイズ</translation>
    </message>
</context>
<context>
    <name>ColorField</name>
    <message>
        <source>Colour code</source>
        <translation>カラーコード</translation>
    </message>
    <message>
        <source>Shadow colour</source>
        <translation>影の色</translation>
    </message>
</context>
<context>
    <name>CommandSearch</name>
    <message>
        <source>Type a part of a command&apos;s name</source>
        <translation>コマンド名の一部を入力</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>コマンドを検索</translation>
    </message>
    <message>
        <source>No command of this name</source>
        <translation>該当するコマンドがありません</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>&amp;New from Cels…</source>
        <translation>セルから新規作成(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>名前を付けて保存(&amp;A)…</translation>
    </message>
    <message>
        <source>Save Ne&amp;xt Version</source>
        <translation>次のバージョンとして保存 (&amp;X)</translation>
    </message>
    <message>
        <source>Import &amp;Pictures…</source>
        <translation>画像を読み込み(&amp;P)…</translation>
    </message>
    <message>
        <source>Set &amp;Background…</source>
        <translation>背景を設定(&amp;B)…</translation>
    </message>
    <message>
        <source>Remove Background</source>
        <translation>背景を外す</translation>
    </message>
    <message>
        <source>Export Notes…</source>
        <translation>メモを書き出し…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>削除(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Take From Project…</source>
        <translation>プロジェクトから取り込む(&amp;T)…</translation>
    </message>
    <message>
        <source>Re&amp;name Layer</source>
        <translation>レイヤー名を変更(&amp;N)</translation>
    </message>
    <message>
        <source>Paste Keys at Their Old Ti&amp;me</source>
        <translation>元の時間にキーを貼り付け (&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Fit in Window</source>
        <translation>ウィンドウに全体を表示(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Actual Pixels (100 %)</source>
        <translation>ピクセル等倍 100 %(&amp;A)</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>拡大(&amp;I)</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>縮小(&amp;O)</translation>
    </message>
    <message>
        <source>View O&amp;utline</source>
        <translation>輪郭を表示 (&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>ハンドル(&amp;H)</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>レビュー</translation>
    </message>
    <message>
        <source>Field &amp;Guide</source>
        <translation>フィールドガイド(&amp;G)</translation>
    </message>
    <message>
        <source>Tak&amp;e Snapshot</source>
        <translation>スナップショットを撮る (&amp;E)</translation>
    </message>
    <message>
        <source>Wipe Snapshot</source>
        <translation>スナップショットをワイプ</translation>
    </message>
    <message>
        <source>&amp;Play / Stop</source>
        <translation>再生／停止(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>ループ再生(&amp;L)</translation>
    </message>
    <message>
        <source>Play &amp;There and Back</source>
        <translation>往復再生 (&amp;T)</translation>
    </message>
    <message>
        <source>Play &amp;Every Frame</source>
        <translation>全フレームを再生(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;First Frame</source>
        <translation>最初のフレーム(&amp;F)</translation>
    </message>
    <message>
        <source>10 Frames Back</source>
        <translation>10フレーム戻る</translation>
    </message>
    <message>
        <source>P&amp;revious Frame</source>
        <translation>前のフレーム(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Next Frame</source>
        <translation>次のフレーム(&amp;N)</translation>
    </message>
    <message>
        <source>10 Frames On</source>
        <translation>10フレーム進む</translation>
    </message>
    <message>
        <source>La&amp;st Frame</source>
        <translation>最後のフレーム(&amp;S)</translation>
    </message>
    <message>
        <source>Work Are&amp;a Ends Here</source>
        <translation>ワークエリアの終了をここに (&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Clear Work Area</source>
        <translation>ワークエリアを解除 (&amp;C)</translation>
    </message>
    <message>
        <source>Show &amp;Body Tilt</source>
        <translation>体の傾きを表示 (&amp;B)</translation>
    </message>
    <message>
        <source>Show Op&amp;acity and Fading</source>
        <translation>不透明度とフェードを表示 (&amp;A)</translation>
    </message>
    <message>
        <source>Previous &amp;Key</source>
        <translation>前のキー(&amp;K)</translation>
    </message>
    <message>
        <source>Next Ke&amp;y</source>
        <translation>次のキー(&amp;Y)</translation>
    </message>
    <message>
        <source>Set &amp;Keys Here</source>
        <translation>ここにキーを設定 (&amp;K)</translation>
    </message>
    <message>
        <source>A&amp;dd Characters…</source>
        <translation>キャラクターを追加(&amp;D)…</translation>
    </message>
    <message>
        <source>Import &amp;3-D Set…</source>
        <translation>3Dセットを読み込む(&amp;3)…</translation>
    </message>
    <message>
        <source>Import &amp;Timesheet…</source>
        <translation>タイムシートを読み込み (&amp;T)…</translation>
    </message>
    <message>
        <source>Export Times&amp;heet…</source>
        <translation>タイムシートを書き出し (&amp;H)…</translation>
    </message>
    <message>
        <source>Set Background Sequence…</source>
        <translation>背景の連番を設定…</translation>
    </message>
    <message>
        <source>&amp;Cut Settings…</source>
        <translation>カット設定(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>書き出し (&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Copy Look</source>
        <translation>見た目をコピー(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste Look</source>
        <translation>見た目を貼り付け(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Transform Cel</source>
        <translation>セルの変形(&amp;T)</translation>
    </message>
    <message>
        <source>Find &amp;Feet</source>
        <translation>足を探す(&amp;F)</translation>
    </message>
    <message>
        <source>Next Dou&amp;btful Drawing</source>
        <translation>次の疑わしいセル(&amp;B)</translation>
    </message>
    <message>
        <source>Previous Doubtful Drawing</source>
        <translation>前の疑わしいセル</translation>
    </message>
    <message>
        <source>Pre&amp;ferences…</source>
        <translation>環境設定(&amp;F)…</translation>
    </message>
    <message>
        <source>Edit &amp;Keyboard Shortcuts…</source>
        <translation>キーボードショートカットを編集 (&amp;K)…</translation>
    </message>
    <message>
        <source>Re&amp;place Drawings…</source>
        <translation>セルを差し替え(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Relink Missing Drawings…</source>
        <translation>見つからないセルを再リンク(&amp;R)…</translation>
    </message>
    <message>
        <source>Show Drawings in &amp;Folder</source>
        <translation>セルのフォルダーを表示(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Duplicate Layer</source>
        <translation>レイヤーを複製(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Lock Layer</source>
        <translation>レイヤーをロック(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Solo Layer</source>
        <translation>レイヤーだけを表示(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Copy Keys</source>
        <translation>キーをコピー (&amp;C)</translation>
    </message>
    <message>
        <source>C&amp;ut Keys</source>
        <translation>キーを切り取り (&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Paste Keys</source>
        <translation>キーを貼り付け (&amp;P)</translation>
    </message>
    <message>
        <source>Select &amp;All Keys</source>
        <translation>すべてのキーを選択 (&amp;A)</translation>
    </message>
    <message>
        <source>Move Keys 1 Frame &amp;Back</source>
        <translation>キーを1フレーム前へ (&amp;B)</translation>
    </message>
    <message>
        <source>Move Keys 1 Frame O&amp;n</source>
        <translation>キーを1フレーム後へ (&amp;N)</translation>
    </message>
    <message>
        <source>Move Keys 10 Frames Back</source>
        <translation>キーを10フレーム前へ</translation>
    </message>
    <message>
        <source>Move Keys 10 Frames On</source>
        <translation>キーを10フレーム後へ</translation>
    </message>
    <message>
        <source>&amp;Easy Ease</source>
        <translation>イージーイーズ (&amp;E)</translation>
    </message>
    <message>
        <source>Ease &amp;In</source>
        <translation>イーズイン (&amp;I)</translation>
    </message>
    <message>
        <source>Ease &amp;Out</source>
        <translation>イーズアウト (&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation>停止 (&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>リニア (&amp;L)</translation>
    </message>
    <message>
        <source>Key &amp;Velocity…</source>
        <translation>キーの速度 (&amp;V)…</translation>
    </message>
    <message>
        <source>&amp;Split Drawing Here</source>
        <translation>ここでセルを分割(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Empty Cel</source>
        <translation>空セルにする(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Remove, Hold the Drawing Before</source>
        <translation>削除して前のセルを伸ばす(&amp;R)</translation>
    </message>
    <message>
        <source>Hold 1 Frame &amp;Longer</source>
        <translation>1 コマ長く止める(&amp;L)</translation>
    </message>
    <message>
        <source>Hold 1 Frame S&amp;horter</source>
        <translation>1 コマ短く止める(&amp;H)</translation>
    </message>
    <message>
        <source>Expose on &amp;Ones</source>
        <translation>1コマ打ち(&amp;O)</translation>
    </message>
    <message>
        <source>Expose on &amp;Twos</source>
        <translation>2コマ打ち(&amp;T)</translation>
    </message>
    <message>
        <source>E&amp;xpose on Threes</source>
        <translation>3コマ打ち(&amp;X)</translation>
    </message>
    <message>
        <source>Expose on &amp;Fours</source>
        <translation>4コマ打ち(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Copy Drawings</source>
        <translation>セルをコピー(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste Drawings</source>
        <translation>セルを貼り付け(&amp;P)</translation>
    </message>
    <message>
        <source>View &amp;Composite</source>
        <translation>合成を表示 (&amp;C)</translation>
    </message>
    <message>
        <source>View Shadow &amp;Only</source>
        <translation>影のみ表示 (&amp;O)</translation>
    </message>
    <message>
        <source>View &amp;Matte</source>
        <translation>マットを表示 (&amp;M)</translation>
    </message>
    <message>
        <source>Camera and Size of the 3-D Set</source>
        <translation>3Dセットのカメラと大きさ</translation>
    </message>
    <message>
        <source>Match Ca&amp;mera to Picture</source>
        <translation>背景にカメラを合わせる(&amp;M)</translation>
    </message>
    <message>
        <source>Look Onl&amp;y</source>
        <translation>閲覧のみ(&amp;Y)</translation>
    </message>
    <message>
        <source>O&amp;nion Skin</source>
        <translation>オニオンスキン (&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Safe Area</source>
        <translation>セーフエリア (&amp;S)</translation>
    </message>
    <message>
        <source>Sho&amp;w Snapshot</source>
        <translation>スナップショットを表示 (&amp;W)</translation>
    </message>
    <message>
        <source>Show &amp;Timeline</source>
        <translation>タイムラインを表示 (&amp;T)</translation>
    </message>
    <message>
        <source>Show &amp;Curve Editor</source>
        <translation>カーブエディターを表示 (&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Hide Panels</source>
        <translation>パネルを隠す (&amp;H)</translation>
    </message>
    <message>
        <source>What Is under the Pointer &amp;Fills the Window; Again: Back</source>
        <translation>ポインターの下を全面に／もう一度で戻す(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>レイアウトをリセット (&amp;R)</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>フルスクリーン (&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Go to Frame…</source>
        <translation>フレームへ移動 (&amp;G)…</translation>
    </message>
    <message>
        <source>Previous &amp;Drawing</source>
        <translation>前のセル (&amp;D)</translation>
    </message>
    <message>
        <source>Next Dra&amp;wing</source>
        <translation>次の動画 (&amp;W)</translation>
    </message>
    <message>
        <source>Work Area &amp;Begins Here</source>
        <translation>ワークエリアの開始をここに (&amp;B)</translation>
    </message>
    <message>
        <source>Read the Work Area &amp;into Memory</source>
        <translation>ワークエリアをメモリーに読み込む(&amp;I)</translation>
    </message>
    <message>
        <source>First Frame of the Work Area</source>
        <translation>ワークエリアの先頭へ</translation>
    </message>
    <message>
        <source>Last Frame of the Work Area</source>
        <translation>ワークエリアの末尾へ</translation>
    </message>
    <message>
        <source>Add or Name &amp;Marker</source>
        <translation>マーカーを追加/名前を変更 (&amp;M)</translation>
    </message>
    <message>
        <source>Previous Note or Flag</source>
        <translation>前のメモまたは注意点</translation>
    </message>
    <message>
        <source>Next Note or Flag</source>
        <translation>次のメモまたは注意点</translation>
    </message>
    <message>
        <source>Tick Note Off</source>
        <translation>メモを済みにする</translation>
    </message>
    <message>
        <source>Previous Marker</source>
        <translation>前のマーカー</translation>
    </message>
    <message>
        <source>Next Marker</source>
        <translation>次のマーカー</translation>
    </message>
    <message>
        <source>Fit the Cut in the &amp;Timeline</source>
        <translation>カット全体をタイムラインに表示 (&amp;T)</translation>
    </message>
    <message>
        <source>Zoom &amp;In on Time</source>
        <translation>時間を拡大 (&amp;I)</translation>
    </message>
    <message>
        <source>Zoom &amp;Out of Time</source>
        <translation>時間を縮小 (&amp;O)</translation>
    </message>
    <message>
        <source>Show Keyed Properties; Again: Cha&amp;nged Ones</source>
        <translation>キーのあるプロパティを表示 / もう一度で変更したもの (&amp;N)</translation>
    </message>
    <message>
        <source>Show &amp;Light</source>
        <translation>ライトを表示 (&amp;L)</translation>
    </message>
    <message>
        <source>Show &amp;Ground</source>
        <translation>地面を表示 (&amp;G)</translation>
    </message>
    <message>
        <source>Show Grounding &amp;Points</source>
        <translation>接地点を表示 (&amp;P)</translation>
    </message>
    <message>
        <source>Show &amp;Shape</source>
        <translation>形状を表示 (&amp;S)</translation>
    </message>
    <message>
        <source>Show &amp;Waves</source>
        <translation>波を表示 (&amp;W)</translation>
    </message>
    <message>
        <source>Show So&amp;ftness</source>
        <translation>ぼかしを表示 (&amp;F)</translation>
    </message>
    <message>
        <source>Add &amp;Wall</source>
        <translation>壁を追加(&amp;W)</translation>
    </message>
    <message>
        <source>Add &amp;Box</source>
        <translation>箱を追加(&amp;B)</translation>
    </message>
    <message>
        <source>Add &amp;Steps</source>
        <translation>階段を追加(&amp;S)</translation>
    </message>
    <message>
        <source>Add &amp;Ramp</source>
        <translation>スロープを追加(&amp;R)</translation>
    </message>
    <message>
        <source>Add &amp;Cylinder</source>
        <translation>円柱を追加(&amp;C)</translation>
    </message>
    <message>
        <source>Add S&amp;phere</source>
        <translation>球を追加(&amp;P)</translation>
    </message>
    <message>
        <source>Draw &amp;Ground and Wall Line</source>
        <translation>接地ラインと壁の線を引く(&amp;G)</translation>
    </message>
    <message>
        <source>Draw Wall &amp;Line</source>
        <translation>壁の線を引く(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Duplicate Set Piece</source>
        <translation>セットを複製(&amp;D)</translation>
    </message>
    <message>
        <source>Re&amp;name Set Piece</source>
        <translation>セットの名前を変更(&amp;N)</translation>
    </message>
    <message>
        <source>Re&amp;move Set Piece</source>
        <translation>セットを削除(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>マニュアル(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Guided First Cut</source>
        <translation>はじめてのカットのガイド(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Find Command…</source>
        <translation>コマンドを検索 (&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts</source>
        <translation>キーボードショートカット(&amp;K)</translation>
    </message>
    <message>
        <source>Copy &amp;Support Report</source>
        <translation>サポート用レポートをコピー(&amp;S)</translation>
    </message>
    <message>
        <source>Missing Parts…</source>
        <translation>足りない部品…</translation>
    </message>
    <message>
        <source>&amp;About Kagezou</source>
        <translation>Kagezou について(&amp;A)</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>編集</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>セル</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>セット</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>ウィンドウ</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
</context>
<context>
    <name>CornerSheet</name>
    <message>
        <source>Drag along the line the figure stands on  ·  Enter: the ground is right  ·  Esc: leave</source>
        <translation>キャラクターが立つ線に沿ってドラッグ  ·  Enter：地面はこのまま  ·  Esc：終了</translation>
    </message>
    <message>
        <source>Drag along the foot of the wall  ·  Esc: leave</source>
        <translation>壁の下端に沿ってドラッグ  ·  Esc：終了</translation>
    </message>
    <message>
        <source>Draw ground line</source>
        <translation>接地ラインを引く</translation>
    </message>
    <message>
        <source>Draw wall</source>
        <translation>壁を引く</translation>
    </message>
    <message>
        <source>There is no ground here for a wall to stand on: begin below the horizon.</source>
        <translation>ここには壁を立てる地面がありません。アイレベルより下から引いてください。</translation>
    </message>
</context>
<context>
    <name>CurveEditor</name>
    <message>
        <source>Nothing is keyed yet: move the playhead and click the diamond before a property.</source>
        <translation>まだキーがありません。再生ヘッドを動かし、プロパティの左のひし形をクリックしてください。</translation>
    </message>
    <message>
        <source>There is no snapshot to exchange with yet.</source>
        <translation>入れ替えるスナップショットがまだありません。</translation>
    </message>
    <message>
        <source>Swap with snapshot</source>
        <translation>スナップショットと入れ替え</translation>
    </message>
    <message>
        <source>No keys are selected.</source>
        <translation>キーが選択されていません。</translation>
    </message>
    <message>
        <source>Key velocity</source>
        <translation>キーの速度</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Flags</source>
        <translation>注意点</translation>
    </message>
    <message>
        <source>Look only: nothing can be changed here, nor anywhere in the window</source>
        <translation>閲覧のみ：ここでもウィンドウのどこでも変更できません</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>What the graph shows</source>
        <translation>グラフの表示内容</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>フィット</translation>
    </message>
    <message>
        <source>Fit the selected keys, else everything (F)</source>
        <translation>選択したキー、なければ全体を表示 (F)</translation>
    </message>
    <message>
        <source>Normalise</source>
        <translation>正規化</translation>
    </message>
    <message>
        <source>Stretch every curve to the same height</source>
        <translation>すべてのカーブを同じ高さで表示</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>選択のみ</translation>
    </message>
    <message>
        <source>Show only curves with selected keys</source>
        <translation>選択したキーのカーブだけを表示</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>スナップショット</translation>
    </message>
    <message>
        <source>Keep the curves as they are, to compare with</source>
        <translation>今のカーブを比較用に残す</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Show the snapshot dashed, and the frames that differ</source>
        <translation>スナップショットを破線で、違うフレームを色で表示</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>入れ替え</translation>
    </message>
    <message>
        <source>Exchange the project with the snapshot</source>
        <translation>プロジェクトとスナップショットを入れ替える</translation>
    </message>
    <message>
        <source>With File…</source>
        <translation>ファイルと…</translation>
    </message>
    <message>
        <source>Compare with another saved version</source>
        <translation>保存した別のバージョンと比較</translation>
    </message>
    <message>
        <source>Look Only</source>
        <translation>閲覧のみ</translation>
    </message>
    <message>
        <source>There is nothing to compare with yet: take a snapshot, or choose a saved version.</source>
        <translation>比べるものがまだありません。スナップショットを撮るか、保存した版を選んでください。</translation>
    </message>
    <message>
        <source>Compare With</source>
        <translation>比較するプロジェクト</translation>
    </message>
    <message>
        <source>Kagezou projects</source>
        <translation>Kagezou プロジェクト</translation>
    </message>
</context>
<context>
    <name>CurveTree</name>
    <message>
        <source>Curves</source>
        <translation>カーブ</translation>
    </message>
</context>
<context>
    <name>CutSettingsDialog</name>
    <message>
        <source>Cut Settings</source>
        <translation>カット設定</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変更</translation>
    </message>
    <message>
        <source>Nothing.</source>
        <translation>変更なし</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>～ %1</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>タイトル</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>シーン</translation>
    </message>
    <message>
        <source>Cut</source>
        <comment>its number</comment>
        <translation>カット</translation>
    </message>
    <message>
        <source>Picture size</source>
        <translation>画面サイズ</translation>
    </message>
    <message>
        <source>What is on it</source>
        <translation>絵の扱い</translation>
    </message>
    <message>
        <source>Frames a second</source>
        <translation>フレームレート</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>seconds + frames</source>
        <translation>秒＋コマ</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>尺</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>開始フレーム</translation>
    </message>
    <message>
        <source>What will change</source>
        <translation>変更される内容</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Length in frames</source>
        <translation>尺（フレーム数）</translation>
    </message>
    <message>
        <source>Length in seconds and frames</source>
        <translation>尺（秒＋コマ）</translation>
    </message>
    <message>
        <source>Stay at Top Left</source>
        <translation>左上を基準に固定</translation>
    </message>
    <message>
        <source>Everything keeps its distance from the upper left corner.</source>
        <translation>すべてが画面の左上からの距離を保ちます。</translation>
    </message>
    <message>
        <source>To the Middle</source>
        <translation>中央に置く</translation>
    </message>
    <message>
        <source>What is in the middle stays there; margins come or go.</source>
        <translation>中央にあるものは中央のまま。周囲の余白だけが増減します。</translation>
    </message>
    <message>
        <source>Scale with It</source>
        <translation>一緒に拡大・縮小</translation>
    </message>
    <message>
        <source>Drawings, light, set and all lengths are scaled alike.</source>
        <translation>セル・ライト・セットとすべての長さを同じ比率で拡大・縮小します。</translation>
    </message>
    <message>
        <source>Change cut settings</source>
        <translation>カット設定を変更</translation>
    </message>
</context>
<context>
    <name>DemoOpener</name>
    <message>
        <source>Drawing the demo: %1 of %2</source>
        <translation>デモを作画中：%1 / %2</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Open Project</source>
        <translation>プロジェクトを開く</translation>
    </message>
    <message>
        <source>Save Project As</source>
        <translation>プロジェクトを名前を付けて保存</translation>
    </message>
    <message>
        <source>Choose a Folder of Cels</source>
        <translation>セルのフォルダーを選択</translation>
    </message>
    <message>
        <source>Choose Folders of Cels</source>
        <translation>セルのフォルダーを選ぶ（複数可）</translation>
    </message>
    <message>
        <source>Choose Cels</source>
        <translation>セルを選択</translation>
    </message>
    <message>
        <source>Choose a Sheet</source>
        <translation>タイムシートを選ぶ</translation>
    </message>
    <message>
        <source>The file holds several timesheets:</source>
        <translation>このファイルには複数のタイムシートがあります：</translation>
    </message>
    <message>
        <source>Choose a Background</source>
        <translation>背景を選択</translation>
    </message>
    <message>
        <source>Choose a Folder of Background Pictures</source>
        <translation>背景の画像のフォルダーを選択</translation>
    </message>
    <message>
        <source>Import Set</source>
        <translation>セットを読み込む</translation>
    </message>
    <message>
        <source>Sets</source>
        <translation>セット</translation>
    </message>
    <message>
        <source>Open Timesheet</source>
        <translation>タイムシートを開く</translation>
    </message>
    <message>
        <source>Timesheets</source>
        <translation>タイムシート</translation>
    </message>
    <message>
        <source>Save Timesheet As</source>
        <translation>タイムシートを保存</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>「%1」への変更を保存しますか？</translation>
    </message>
    <message>
        <source>They are lost if you do not save them.</source>
        <translation>保存しないと変更は失われます。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Don&apos;t Save</source>
        <translation>保存しない</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>“%1” is open in another window. Open it here too?</source>
        <translation>「%1」は別のウィンドウで開かれています。ここでも開きますか？</translation>
    </message>
    <message>
        <source>Open Anyway</source>
        <translation>それでも開く</translation>
    </message>
    <message>
        <source>“%1” is there already. Replace it?</source>
        <translation>「%1」はすでにあります。置き換えますか？</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換える</translation>
    </message>
    <message>
        <source>Projects, timesheets, PSD and OCA files</source>
        <translation>プロジェクト、タイムシート、PSD、OCA</translation>
    </message>
    <message>
        <source>Take From Project</source>
        <translation>プロジェクトから取り込む</translation>
    </message>
    <message>
        <source>Whoever saves last wins. The other window is on this computer.</source>
        <translation>後から保存した方が残ります。もう一つのウィンドウはこのコンピューターで開いています。</translation>
    </message>
    <message>
        <source>Whoever saves last wins. The other window is on %1.</source>
        <translation>後から保存した方が残ります。もう一つのウィンドウは %1 で開いています。</translation>
    </message>
    <message>
        <source>“%1” was changed outside this window. Replace it?</source>
        <translation>「%1」はこのウィンドウの外で変更されています。置き換えますか?</translation>
    </message>
    <message>
        <source>What was changed there would be kept only as its backup (%1~).</source>
        <translation>外で変更された内容は、バックアップ(%1~)としてのみ残ります。</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>名前を付けて保存…</translation>
    </message>
    <message>
        <source>Kagezou projects</source>
        <translation>Kagezou プロジェクト</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>“%1” is being saved.</source>
        <translation>「%1」を保存しています。</translation>
    </message>
    <message>
        <source>This goes on by itself as soon as it is written.</source>
        <translation>書き込みが終わると自動的に続きます。</translation>
    </message>
</context>
<context>
    <name>Dock</name>
    <message>
        <source>Float or dock</source>
        <translation>切り離す／戻す</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>Docks</name>
    <message>
        <source>Layers</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>プロパティ</translation>
    </message>
    <message>
        <source>Styles</source>
        <translation>スタイル</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>カーブ</translation>
    </message>
</context>
<context>
    <name>DrawingCommands</name>
    <message>
        <source>Split drawing</source>
        <translation>セルを分割</translation>
    </message>
    <message>
        <source>Insert drawing</source>
        <translation>セルを挿入</translation>
    </message>
    <message>
        <source>Empty cel</source>
        <translation>空セルにする</translation>
    </message>
    <message>
        <source>Replace drawing</source>
        <translation>セルを差し替え</translation>
    </message>
    <message>
        <source>Remove drawing</source>
        <translation>セルを削除</translation>
    </message>
    <message>
        <source>Hold longer</source>
        <translation>長く止める</translation>
    </message>
    <message>
        <source>Hold shorter</source>
        <translation>短く止める</translation>
    </message>
    <message>
        <source>The last drawing holds to the end of the cut; drag its end to shorten it.</source>
        <translation>最後のセルはカットの終わりまで続きます。短くするには端をドラッグしてください。</translation>
    </message>
    <message>
        <source>Expose on %1s</source>
        <translation>%1コマ打ち</translation>
    </message>
    <message>
        <source>No drawings were copied yet.</source>
        <translation>まだセルがコピーされていません。</translation>
    </message>
    <message>
        <source>Paste drawings</source>
        <translation>セルを貼り付け</translation>
    </message>
    <message>
        <source>%1 has no drawings of these names, and they stay empty: %2</source>
        <translation>%1 に同じ名前のセルがないため空セルになりました：%2</translation>
    </message>
    <message>
        <source>No drawing is exposed at the playhead.</source>
        <translation>再生ヘッドの位置にセルがありません。</translation>
    </message>
</context>
<context>
    <name>DrawingController</name>
    <message>
        <source>empty</source>
        <translation>空セル</translation>
    </message>
    <message>
        <source>%1: frames %2 to %3, held %4</source>
        <translation>%1：%2～%3 フレーム、%4 コマ</translation>
    </message>
    <message>
        <source>Drag an end to hold it longer or shorter (Shift: what follows moves along; Alt or A: over its neighbours), the middle to move it</source>
        <translation>端をドラッグして長さを変えます（Shift：後ろも動く、Alt / A：隣を越える）。中央をドラッグして動かします</translation>
    </message>
    <message>
        <source>Move drawing</source>
        <translation>セルを移動</translation>
    </message>
    <message>
        <source>Hold drawing</source>
        <translation>セルの長さを変更</translation>
    </message>
    <message>
        <source>held %1</source>
        <translation>%1 コマ</translation>
    </message>
</context>
<context>
    <name>DrawingMenu</name>
    <message>
        <source>Replace With</source>
        <translation>差し替え</translation>
    </message>
    <message>
        <source>Insert at the Playhead</source>
        <translation>再生ヘッドの位置に挿入</translation>
    </message>
</context>
<context>
    <name>DropHint</name>
    <message>
        <source>Open %1</source>
        <translation>%1 を開く</translation>
    </message>
    <message>
        <source>Put %1 behind the characters</source>
        <translation>%1 をキャラクターの後ろに置く</translation>
    </message>
    <message>
        <source>Put %1 under everything</source>
        <translation>%1 を背景にする</translation>
    </message>
    <message>
        <source>Bring in %1</source>
        <translation>%1 を読み込む</translation>
    </message>
    <message>
        <source>Bring in %1 and %2 more</source>
        <translation>%1 ほか %2 件を読み込む</translation>
    </message>
</context>
<context>
    <name>EditedProperty</name>
    <message>
        <source>Reset %1</source>
        <translation>%1をリセット</translation>
    </message>
    <message>
        <source>Remove key of %1</source>
        <translation>%1のキーを削除</translation>
    </message>
    <message>
        <source>Key %1</source>
        <translation>%1にキーを設定</translation>
    </message>
    <message>
        <source>Remove all keys of %1</source>
        <translation>%1のキーをすべて削除</translation>
    </message>
    <message>
        <source>Unlink %1</source>
        <translation>%1の共通を解除</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>%1を共通にする</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1を変更</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Export</source>
        <translation>書き出し</translation>
    </message>
    <message>
        <source>What will be written</source>
        <translation>書き出される内容</translation>
    </message>
    <message>
        <source>How to Add It…</source>
        <translation>追加のしかた…</translation>
    </message>
    <message>
        <source>Choose a folder.</source>
        <translation>フォルダーを選択してください。</translation>
    </message>
    <message>
        <source>The project is not saved yet, so a folder in your documents is proposed.</source>
        <translation>プロジェクトがまだ保存されていないので、書類フォルダーの中を提案しています。</translation>
    </message>
    <message>
        <source>Another folder than the one beside the project is remembered for this project.</source>
        <translation>プロジェクトの隣以外を選ぶと、このプロジェクトの書き出し先として記憶されます。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>参照…</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Export To</source>
        <translation>書き出し先</translation>
    </message>
</context>
<context>
    <name>ExportOptions</name>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>ビット数</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Missing drawings</source>
        <translation>見つからないセル</translation>
    </message>
    <message>
        <source>%1 bit</source>
        <translation>%1 bit</translation>
    </message>
    <message>
        <source>%1 has no other depth.</source>
        <translation>%1 のビット数はこれだけです。</translation>
    </message>
    <message>
        <source>One file with all layers has it already.</source>
        <translation>全レイヤーを収めたファイルに、すでに含まれています。</translation>
    </message>
    <message>
        <source>All layers of a frame in one file</source>
        <translation>1フレームの全レイヤーを1つのファイルに</translation>
    </message>
    <message>
        <source>Shadows of a look as one besides</source>
        <translation>同じ見た目の影をまとめた連番も書き出す</translation>
    </message>
    <message>
        <source>Composite with background and characters</source>
        <translation>背景・キャラクターとの合成も書き出す</translation>
    </message>
    <message>
        <source>Only the work area</source>
        <translation>ワークエリアのみ</translation>
    </message>
    <message>
        <source>the cut has none</source>
        <translation>このカットには設定されていません</translation>
    </message>
    <message>
        <source>Each different shadow once, held by time remapping</source>
        <translation>異なる影を1枚ずつ書き出し、タイムリマップで保持</translation>
    </message>
    <message>
        <source>Copy characters and background into the folder</source>
        <translation>キャラクターと背景をフォルダーにコピー</translation>
    </message>
    <message>
        <source>A null whose sliders drive all shadows</source>
        <translation>すべての影を動かすスライダー付きヌル</translation>
    </message>
    <message>
        <source> frames a task</source>
        <translation> フレーム / タスク</translation>
    </message>
    <message>
        <source>Leave frames alone that would come out the same</source>
        <translation>変わらないフレームは書き出さない</translation>
    </message>
    <message>
        <source>Shadow of %1</source>
        <translation>%1 の影</translation>
    </message>
    <message>
        <source>Finished picture</source>
        <translation>完成画面</translation>
    </message>
    <message>
        <source>Export nothing, name them</source>
        <translation>書き出さずに名前を挙げる</translation>
    </message>
    <message>
        <source>Leave the frames empty</source>
        <translation>フレームを空にする</translation>
    </message>
    <message>
        <source>Hold the nearest drawing</source>
        <translation>近くのセルで埋める</translation>
    </message>
    <message>
        <source>PSD, opacity and blend mode kept</source>
        <translation>PSD（不透明度と描画モードを保持）</translation>
    </message>
    <message>
        <source>MP4, H.264, to look at</source>
        <translation>MP4（H.264、確認用）</translation>
    </message>
    <message>
        <source>MOV, ProRes 4444, with alpha</source>
        <translation>MOV（ProRes 4444、アルファ付き）</translation>
    </message>
    <message>
        <source>Matte: the shadow alone</source>
        <translation>マット：影のみ</translation>
    </message>
    <message>
        <source>Matte: the part near the feet</source>
        <translation>マット：足元の部分</translation>
    </message>
    <message>
        <source>Matte: distance from the feet</source>
        <translation>マット：足元からの距離</translation>
    </message>
    <message>
        <source>Matte: what no shadow lies on</source>
        <translation>マット：影のない部分</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>an option, and why it is not there</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Mattes: the ground and every set piece</source>
        <translation>マット：地面とセットのそれぞれ</translation>
    </message>
</context>
<context>
    <name>ExportResult</name>
    <message>
        <source>Export</source>
        <translation>書き出し</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Show in Folder</source>
        <translation>フォルダーに表示</translation>
    </message>
    <message>
        <source>Copy Path</source>
        <translation>パスをコピー</translation>
    </message>
    <message>
        <source>The export was stopped: %1 of %2 files are there, all whole.</source>
        <translation>書き出しを中止しました。%2 ファイル中 %1 ファイルがあり、どれも完全です。</translation>
    </message>
    <message>
        <source>The export is not complete: %1 of %2 files are there, all whole.</source>
        <translation>書き出しは完了していません。%2 ファイル中 %1 ファイルがあり、どれも完全です。</translation>
    </message>
    <message>
        <source>The export is complete.</source>
        <translation>書き出しが完了しました。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>次にすること</translation>
    </message>
    <message>
        <source>How to go on</source>
        <translation>続けるには</translation>
    </message>
    <message>
        <source>Already there, and left as they were: %1</source>
        <translation>すでにあり、そのまま残したもの：%1</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>No program of this desktop opens folders; the path can be copied.</source>
        <translation>フォルダーを開くソフトがありません。パスはコピーできます。</translation>
    </message>
</context>
<context>
    <name>Exporting</name>
    <message>
        <source>Exporting</source>
        <translation>書き出し中</translation>
    </message>
    <message>
        <source>Cancel the export</source>
        <translation>書き出しを中止</translation>
    </message>
    <message>
        <source>Preparing the export</source>
        <translation>書き出しを準備中</translation>
    </message>
    <message>
        <source>An export is still running.</source>
        <translation>書き出しはまだ実行中です。</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>停止中</translation>
    </message>
    <message>
        <source>Every file that was written before is whole and stays.</source>
        <translation>それまでに書き出したファイルはどれも完全で、そのまま残ります。</translation>
    </message>
    <message>
        <source>Finishing the export</source>
        <translation>書き出しの仕上げ中</translation>
    </message>
    <message>
        <source>Exporting, %1 s left</source>
        <translation>書き出し中、残り %1 秒</translation>
    </message>
    <message>
        <source>Exporting, %1 min left</source>
        <translation>書き出し中、残り %1 分</translation>
    </message>
</context>
<context>
    <name>FeetLane</name>
    <message>
        <source>In the air, %1 px high</source>
        <translation>空中、高さ %1 px</translation>
    </message>
    <message>
        <source>%1 of %2 feet planted</source>
        <translation>%2 本中 %1 本の足が接地</translation>
    </message>
    <message>
        <source>No foot seen</source>
        <translation>足が見えません</translation>
    </message>
    <message>
        <source>doubtful: please look whether this is right</source>
        <translation>疑わしい：正しいか確認してください</translation>
    </message>
    <message>
        <source>pinned by hand</source>
        <translation>手で固定</translation>
    </message>
</context>
<context>
    <name>Figures</name>
    <message>
        <source>Drag the cel to move it, a corner to scale it, outside of a corner to turn it; Shift constrains. Esc ends it.</source>
        <translation>セルをドラッグで移動、角で拡大・縮小、角の外側で回転。Shift で制限。Esc で終了。</translation>
    </message>
    <message>
        <source>There is no more drawing with doubtful feet in this direction.</source>
        <translation>この方向に足の疑わしいセルはもうありません。</translation>
    </message>
</context>
<context>
    <name>FirstCut</name>
    <message>
        <source>Drag the light in the picture, here the sun on its dial under the feet: the shadow follows.</source>
        <translation>足の下の文字盤にある太陽（ライト）をドラッグしてください。影がついてきます。</translation>
    </message>
    <message>
        <source>Say from how high the ground is seen: drag the lever under the feet, or Declination.</source>
        <translation>どの高さから地面を見ているかを決めます。足の下のつまみ、または［地面の角度］をドラッグしてください。</translation>
    </message>
    <message>
        <source>Make the shape as simple as it would be drawn: drag Simplify, under Shape.</source>
        <translation>手で描くような単純な形にします。［形状］の［単純化］をドラッグしてください。</translation>
    </message>
    <message>
        <source>Let it change over time: click the diamond before Opacity, go to another frame, and change the value.</source>
        <translation>時間で変化させます。［不透明度］の左のひし形をクリックし、別のコマへ移って値を変えてください。</translation>
    </message>
    <message>
        <source>Hand it over: press Export at the top right, choose After Effects, and export.</source>
        <translation>書き出します。右上の［書き出し］を押し、After Effects を選んで書き出してください。</translation>
    </message>
    <message>
        <source>That was a whole cut. F1 opens the page of the manual about whatever is under the pointer.</source>
        <translation>これで一つのカットができました。F1 を押すと、マウスの下にあるものの説明がマニュアルで開きます。</translation>
    </message>
</context>
<context>
    <name>FirstCutBar</name>
    <message>
        <source>Show Me</source>
        <translation>場所を表示</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>飛ばす</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>手順 %1 / %2</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>やめる</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>FlagList</name>
    <message>
        <source>Flags</source>
        <translation>注意点</translation>
    </message>
    <message>
        <source>Places that move farther than this in a frame</source>
        <translation>1 フレームにこれより大きく動く位置</translation>
    </message>
    <message>
        <source>Too fast:</source>
        <translation>速すぎ：</translation>
    </message>
    <message>
        <source>Nothing stands out.</source>
        <translation>目立つ点はありません。</translation>
    </message>
</context>
<context>
    <name>Flags</name>
    <message>
        <source>and %1 more: keys between two drawings</source>
        <translation>ほか %1 件：セルの切り替わりにないキー</translation>
    </message>
    <message>
        <source>key between two drawings</source>
        <translation>セルの切り替わりにないキー</translation>
    </message>
    <message>
        <source>jumps by %1</source>
        <translation>%1 飛んでいます</translation>
    </message>
    <message>
        <source>moves by up to %1 a frame, to frame %2</source>
        <translation>1 フレームに最大 %1 動いています（フレーム %2 まで）</translation>
    </message>
</context>
<context>
    <name>FootMenu</name>
    <message>
        <source>Planted</source>
        <translation>接地</translation>
    </message>
    <message>
        <source>Lifted</source>
        <translation>浮いている</translation>
    </message>
    <message>
        <source>No Foot</source>
        <translation>足ではない</translation>
    </message>
    <message>
        <source>Pin as It Is</source>
        <translation>現在のまま固定</translation>
    </message>
    <message>
        <source>As Found (Unpin)</source>
        <translation>見つかったまま（固定を解除）</translation>
    </message>
</context>
<context>
    <name>FoundDialog</name>
    <message>
        <source>Characters Found</source>
        <translation>見つかったキャラクター</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>取り込む</translation>
    </message>
    <message>
        <source>of its own</source>
        <translation>独立</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>キャラクター</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>Which layer of the OpenEXR files is the drawing</source>
        <translation>OpenEXR ファイルのどのレイヤーをセルとして使うか</translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>名前なし</translation>
    </message>
    <message>
        <source>This is what was found. Lower rows lie over upper ones.</source>
        <translation>次のものが見つかりました。下の行ほど手前に重なります。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>枚数</translation>
    </message>
    <message>
        <source>First and last file</source>
        <translation>最初と最後のファイル</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>備考</translation>
    </message>
    <message>
        <source>part of %1</source>
        <translation>%1 の一部</translation>
    </message>
</context>
<context>
    <name>FrameField</name>
    <message>
        <source>Frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Frame; type 84, 3+12 (seconds + frames) or +6</source>
        <translation>フレーム：84、3+12（秒＋コマ）、+6 のように入力</translation>
    </message>
</context>
<context>
    <name>Graph</name>
    <message>
        <source>Curves over time</source>
        <translation>時間上のカーブ</translation>
    </message>
</context>
<context>
    <name>GraphController</name>
    <message>
        <source>Move handle</source>
        <translation>ハンドルを移動</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>キーを移動</translation>
    </message>
    <message>
        <source>Add key</source>
        <translation>キーを追加</translation>
    </message>
</context>
<context>
    <name>HandleController</name>
    <message>
        <source>Move %1</source>
        <translation>%1を移動</translation>
    </message>
    <message>
        <source>Nudge %1</source>
        <translation>%1を微調整</translation>
    </message>
    <message>
        <source>Double-click on the character itself to say where it touches the ground.</source>
        <translation>接地する場所は、キャラクターの上をダブルクリックして指定します。</translation>
    </message>
    <message>
        <source>Add foot</source>
        <translation>足を追加</translation>
    </message>
    <message>
        <source>Add grounding point</source>
        <translation>接地点を追加</translation>
    </message>
    <message>
        <source>Remove grounding point</source>
        <translation>接地点を削除</translation>
    </message>
    <message>
        <source>Plant foot</source>
        <translation>足を接地</translation>
    </message>
    <message>
        <source>Lift foot</source>
        <translation>足を浮かせる</translation>
    </message>
    <message>
        <source>Remove foot</source>
        <translation>足を削除</translation>
    </message>
    <message>
        <source>Pin foot</source>
        <translation>足を固定</translation>
    </message>
    <message>
        <source>Unpin foot</source>
        <translation>足の固定を解除</translation>
    </message>
</context>
<context>
    <name>HandleMenu</name>
    <message>
        <source>Type Values…</source>
        <translation>値を入力…</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>About Kagezou</source>
        <translation>Kagezou について</translation>
    </message>
    <message>
        <source>Cast-shadow layers for 2D animation, from the alpha of the character drawings.</source>
        <translation>キャラクターのセルのアルファから、2Dアニメーションの落ち影レイヤーを作ります。</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>バージョン %1</translation>
    </message>
    <message>
        <source>Graphics: %1</source>
        <translation>グラフィックス：%1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Under the Apache License 2.0. Qt is used under the GNU LGPL 3.</source>
        <translation>Apache License 2.0 で提供しています。Qt は GNU LGPL 3 に基づいて使用しています。</translation>
    </message>
    <message>
        <source>Play / stop</source>
        <translation>再生／停止</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>スペース</translation>
    </message>
    <message>
        <source>Move the picture</source>
        <translation>画面の移動</translation>
    </message>
    <message>
        <source>Space + drag</source>
        <translation>スペース + ドラッグ</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>中ボタン</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>ポインター位置で拡大・縮小</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>ホイール</translation>
    </message>
    <message>
        <source>Add a grounding point</source>
        <translation>接地点を追加</translation>
    </message>
    <message>
        <source>Double click on the character</source>
        <translation>キャラクターをダブルクリック</translation>
    </message>
    <message>
        <source>Keep to one axis, or to steps of 15°</source>
        <translation>一方向に固定／15°刻み</translation>
    </message>
    <message>
        <source>Shift + drag</source>
        <translation>Shift + ドラッグ</translation>
    </message>
    <message>
        <source>Alt + drag</source>
        <translation>Alt + ドラッグ</translation>
    </message>
    <message>
        <source>Shift + Alt + drag</source>
        <translation>Shift + Alt + ドラッグ</translation>
    </message>
    <message>
        <source>Ctrl + drag</source>
        <translation>Ctrl + ドラッグ</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Right button</source>
        <translation>右ボタン</translation>
    </message>
    <message>
        <source>Set the exact value while dragging</source>
        <translation>ドラッグ中に数値を直接入力</translation>
    </message>
    <message>
        <source>Digits</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>Hide or show the panels, while no handle or field has the keyboard</source>
        <translation>パネルの表示/非表示（ハンドルや入力欄を操作していないとき）</translation>
    </message>
    <message>
        <source>Nudge the selected handle by 1 px, with Shift by 10 px</source>
        <translation>選択中のハンドルを 1 px（Shift で 10 px）動かす</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>矢印キー</translation>
    </message>
    <message>
        <source>Move the counterpart the opposite way</source>
        <translation>対になる点を逆方向に動かす</translation>
    </message>
    <message>
        <source>Drag at a tenth of the speed</source>
        <translation>10分の1の速さで動かす</translation>
    </message>
    <message>
        <source>Do not snap</source>
        <translation>スナップしない</translation>
    </message>
    <message>
        <source>Take a drag back</source>
        <translation>ドラッグを取り消す</translation>
    </message>
    <message>
        <source>Select the next handle</source>
        <translation>次のハンドルを選択</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Change a number faster or slower</source>
        <translation>数値を速く／ゆっくり変える</translation>
    </message>
    <message>
        <source>Calculate in a number field</source>
        <translation>数値欄で計算する</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Kagezou crashed the last time. What is known of it is in %1</source>
        <translation>前回 Kagezou が異常終了しました。わかっている内容：%1</translation>
    </message>
    <message>
        <source>The report is on the clipboard. It holds names of files from the log: read it before you send it</source>
        <translation>レポートをクリップボードにコピーしました。ログのファイル名を含みます。送る前に内容をご確認ください</translation>
    </message>
    <message>
        <source>Copy Report</source>
        <translation>レポートをコピー</translation>
    </message>
    <message>
        <source>Show Folder</source>
        <translation>フォルダーを表示</translation>
    </message>
    <message>
        <source>Drawings in memory: %1 of %2. Free memory: %3</source>
        <translation>メモリ内のセル：%1／%2&#x3000;空きメモリ：%3</translation>
    </message>
</context>
<context>
    <name>Inspector</name>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Place and size</source>
        <translation>位置と寸法</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>はたらき</translation>
    </message>
    <message>
        <source>Shadow</source>
        <translation>影</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Fading</source>
        <translation>フェード</translation>
    </message>
    <message>
        <source>Placement</source>
        <translation>配置</translation>
    </message>
    <message>
        <source>In a jump</source>
        <translation>跳躍</translation>
    </message>
    <message>
        <source>Waves</source>
        <translation>波</translation>
    </message>
    <message>
        <source>Contact with the ground</source>
        <translation>接地</translation>
    </message>
    <message>
        <source>Reflection</source>
        <translation>映り込み</translation>
    </message>
    <message>
        <source>Shadow of the set</source>
        <translation>セットの影</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>キャラクター</translation>
    </message>
    <message>
        <source>Part of %1, which has the shadow of both</source>
        <translation>%1 の一部（影は %1 が両方の分を持ちます）</translation>
    </message>
    <message>
        <source>%1 layers together: %2</source>
        <translation>%1 レイヤーをまとめて編集：%2</translation>
    </message>
</context>
<context>
    <name>KeyButton</name>
    <message>
        <source>No keys. Click to set a key on this frame</source>
        <translation>キーなし。クリックでこのフレームにキーを設定</translation>
    </message>
    <message>
        <source>Keyed on other frames. Click to set a key on this frame</source>
        <translation>他のフレームにキーあり。クリックでこのフレームにキーを設定</translation>
    </message>
    <message>
        <source>Keyed on this frame. Click to remove the key</source>
        <translation>このフレームにキーあり。クリックでキーを削除</translation>
    </message>
</context>
<context>
    <name>KeyCommands</name>
    <message>
        <source>No keys are selected.</source>
        <translation>キーが選択されていません。</translation>
    </message>
    <message>
        <source>Cut keys</source>
        <translation>キーを切り取り</translation>
    </message>
    <message>
        <source>Delete keys</source>
        <translation>キーを削除</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>キーを移動</translation>
    </message>
    <message>
        <source>Easy ease</source>
        <translation>イージーイーズ</translation>
    </message>
    <message>
        <source>Ease in</source>
        <translation>イーズイン</translation>
    </message>
    <message>
        <source>Ease out</source>
        <translation>イーズアウト</translation>
    </message>
    <message>
        <source>Hold keys</source>
        <translation>キーを停止</translation>
    </message>
    <message>
        <source>Make keys linear</source>
        <translation>キーをリニアに</translation>
    </message>
    <message>
        <source>Make keys bezier</source>
        <translation>キーをベジェに</translation>
    </message>
    <message>
        <source>Nothing is keyed yet; click the diamond before a property in the inspector.</source>
        <translation>まだキーがありません。インスペクターでプロパティの左のひし形をクリックしてください。</translation>
    </message>
    <message>
        <source>Set keys</source>
        <translation>キーを設定</translation>
    </message>
    <message>
        <source>Clear work area</source>
        <translation>ワークエリアを解除</translation>
    </message>
    <message>
        <source>Set work area</source>
        <translation>ワークエリアを設定</translation>
    </message>
    <message>
        <source>Nothing in this project takes the copied keys, or they are more than a project holds.</source>
        <translation>コピーしたキーを受け取れるものがこのプロジェクトにないか、プロジェクトに入る数を超えています。</translation>
    </message>
    <message>
        <source>No keys were copied yet.</source>
        <translation>まだキーがコピーされていません。</translation>
    </message>
    <message>
        <source>Paste keys</source>
        <translation>キーを貼り付け</translation>
    </message>
    <message>
        <source>The copied keys belong to layers that are not in this project.</source>
        <translation>コピーしたキーのレイヤーが、このプロジェクトにありません。</translation>
    </message>
</context>
<context>
    <name>KeyController</name>
    <message>
        <source>Stretch keys</source>
        <translation>キーを伸縮</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>キーを移動</translation>
    </message>
</context>
<context>
    <name>KeyTable</name>
    <message>
        <source>Frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>成分</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Goes on</source>
        <translation>補間</translation>
    </message>
    <message>
        <source>Infl. in %</source>
        <translation>入り影響%</translation>
    </message>
    <message>
        <source>Infl. out %</source>
        <translation>出影響%</translation>
    </message>
    <message>
        <source>Speed in /frame</source>
        <translation>入る速度 /コマ</translation>
    </message>
    <message>
        <source>Speed out /frame</source>
        <translation>出る速度 /コマ</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Paste keys</source>
        <translation>キーを貼り付け</translation>
    </message>
    <message>
        <source>Type key</source>
        <translation>キーを入力</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>リニア</translation>
    </message>
    <message>
        <source>bezier</source>
        <translation>ベジェ</translation>
    </message>
</context>
<context>
    <name>Keyboard</name>
    <message>
        <source>Your own shortcuts could not be read; the set&apos;s are used.</source>
        <translation>カスタムショートカットを読み込めなかったため、セットの設定を使います。</translation>
    </message>
</context>
<context>
    <name>KeysOfCommand</name>
    <message>
        <source>Press the new keys</source>
        <translation>新しいキーを押してください</translation>
    </message>
    <message>
        <source>Click here, then press the new keys</source>
        <translation>ここをクリックして新しいキーを押してください</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>リセット</translation>
    </message>
    <message>
        <source>Move It Here</source>
        <translation>ここへ移す</translation>
    </message>
    <message>
        <source>Keys of “%1”</source>
        <translation>「%1」のキー</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>コマンドを選択</translation>
    </message>
    <message>
        <source>Not every keyboard has %1: add a second shortcut.</source>
        <translation>%1 がないキーボードもあります。もう一つ割り当ててください。</translation>
    </message>
    <message>
        <source>Add:</source>
        <translation>追加:</translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation>%1 を外す</translation>
    </message>
    <message>
        <source>%1 belongs to the picture and the fields.</source>
        <translation>%1 は画面と入力欄が使います。</translation>
    </message>
    <message>
        <source>%1 already belongs to “%2”.</source>
        <translation>%1 は既に「%2」に割り当てられています。</translation>
    </message>
</context>
<context>
    <name>Lanes</name>
    <message>
        <source>Keys and drawings over time</source>
        <translation>時間上のキーとセル</translation>
    </message>
</context>
<context>
    <name>Language</name>
    <message>
        <source>English</source>
        <comment>what the language calls itself</comment>
        <translation>日本語</translation>
    </message>
    <message>
        <source>en</source>
        <comment>the code of the language translated to</comment>
        <translation>ja</translation>
    </message>
</context>
<context>
    <name>LayerDelegate</name>
    <message>
        <source>Layer name</source>
        <translation>レイヤー名</translation>
    </message>
</context>
<context>
    <name>LayerFiles</name>
    <message>
        <source>Replace drawings</source>
        <translation>セルを差し替え</translation>
    </message>
    <message>
        <source>Relink drawings</source>
        <translation>セルを再リンク</translation>
    </message>
</context>
<context>
    <name>LayerList</name>
    <message>
        <source>Remove layer</source>
        <translation>レイヤーを削除</translation>
    </message>
    <message>
        <source>No layers yet.
Drop a folder of cels here.</source>
        <translation>レイヤーがありません。
セルのフォルダーをここにドロップ。</translation>
    </message>
    <message>
        <source>Add cels as a new layer</source>
        <translation>セルを新しいレイヤーとして追加</translation>
    </message>
    <message>
        <source>Join Figure</source>
        <translation>キャラクターに結合</translation>
    </message>
    <message>
        <source>Make a Figure of Its Own</source>
        <translation>独立したキャラクターにする</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前を変更</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隠す</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Copy Look</source>
        <translation>見た目をコピー</translation>
    </message>
    <message>
        <source>Paste Look</source>
        <translation>見た目を貼り付け</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>上へ移動</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>下へ移動</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>White inside Outlines Stays</source>
        <translation>線の内側の白を残す</translation>
    </message>
    <message>
        <source>For drawings without alpha: only white that reaches the border is clear, so that white shirts, hair and eyes stay. White between arm and body stays, too.</source>
        <translation>アルファのないセルで、画像の縁につながる白だけを透明にします。白い服や髪、目は残ります。腕と体の間の白も残ります。</translation>
    </message>
</context>
<context>
    <name>LayerModel</name>
    <message numerus="yes">
        <source>%n drawing(s)</source>
        <translation>
            <numerusform>セル %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>レイヤーを表示</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>レイヤーを隠す</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>レイヤー名を変更</translation>
    </message>
    <message>
        <source>Paper of drawings</source>
        <translation>セルの紙の扱い</translation>
    </message>
    <message>
        <source>Reorder layers</source>
        <translation>レイヤーの順序を変更</translation>
    </message>
    <message>
        <source>Split figure</source>
        <translation>キャラクターを分ける</translation>
    </message>
    <message>
        <source>Join figure</source>
        <translation>キャラクターに結合</translation>
    </message>
    <message>
        <source>%1 missing files in</source>
        <comment>then a folder</comment>
        <translation>見つからないファイル %1 個：</translation>
    </message>
    <message>
        <source>%1, %2 missing</source>
        <translation>%1（%2 枚が見つかりません）</translation>
    </message>
    <message>
        <source>%1, part of %2</source>
        <translation>%1、%2 の一部</translation>
    </message>
</context>
<context>
    <name>LayerView</name>
    <message>
        <source>Layers</source>
        <translation>レイヤー</translation>
    </message>
</context>
<context>
    <name>Layers</name>
    <message>
        <source>Lock layer</source>
        <translation>レイヤーをロック</translation>
    </message>
    <message>
        <source>Solo layer</source>
        <translation>レイヤーだけを表示</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>レイヤーを複製</translation>
    </message>
    <message>
        <source>%1 is locked, so nothing is changed. Lock Layer in the Layer menu unlocks it.</source>
        <translation>%1 はロックされているため変更されません。「レイヤー」メニューの「レイヤーをロック」で解除できます。</translation>
    </message>
    <message>
        <source>Label layer</source>
        <translation>レイヤーのラベル</translation>
    </message>
    <message>
        <source>None</source>
        <comment>no label</comment>
        <translation>なし</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>赤</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>オレンジ</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>緑</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>青</translation>
    </message>
    <message>
        <source>Purple</source>
        <translation>紫</translation>
    </message>
    <message>
        <source>Pink</source>
        <translation>ピンク</translation>
    </message>
</context>
<context>
    <name>LinkButton</name>
    <message>
        <source>The same for all characters. Click to give each its own</source>
        <translation>全キャラクターで共通です。クリックするとキャラクターごとの値に戻ります</translation>
    </message>
    <message>
        <source>Click to make it the same for all characters, values and keys</source>
        <translation>クリックすると値もキーも全キャラクターで共通になります</translation>
    </message>
</context>
<context>
    <name>Loading</name>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>残り %1 秒</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1を開いています</translation>
    </message>
    <message>
        <source>Looking through the drawings of %1</source>
        <translation>%1のセルを調べています</translation>
    </message>
    <message>
        <source>Measuring the figure of %1</source>
        <translation>%1のキャラクターの位置を測っています</translation>
    </message>
    <message>
        <source>Finding a place for the lamp for %1</source>
        <translation>%1のライトの位置を探しています</translation>
    </message>
    <message>
        <source>Looking for the feet of %1</source>
        <translation>%1 の足を探しています</translation>
    </message>
    <message>
        <source>Comparing the drawings of %1 with those of before</source>
        <translation>%1のセルを前のセルと比べています</translation>
    </message>
    <message>
        <source>Reading drawings of %1</source>
        <translation>%1のセルを読み込んでいます</translation>
    </message>
</context>
<context>
    <name>Lock</name>
    <message>
        <source>Look Only is on, so nothing is changed; it is in the View menu.</source>
        <translation>「閲覧のみ」がオンなので、何も変わりません（［表示］メニューで切り替えます）。</translation>
    </message>
</context>
<context>
    <name>LookClipboard</name>
    <message>
        <source>There is no look on the clipboard; copy one from a layer first.</source>
        <translation>クリップボードに見た目がありません。先にレイヤーからコピーしてください。</translation>
    </message>
    <message>
        <source>Paste look</source>
        <translation>見た目を貼り付け</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>(saving…)</source>
        <translation>（保存中…）</translation>
    </message>
</context>
<context>
    <name>Manual</name>
    <message>
        <source>Kagezou Manual</source>
        <translation>Kagezou マニュアル</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>進む</translation>
    </message>
</context>
<context>
    <name>Match</name>
    <message>
        <source>Lay the two orange lines along edges of the floor that run away, the two blue ones along edges square to them. The dash-dotted line is the horizon. Esc ends it.</source>
        <translation>オレンジの2本を奥へ向かう床の線に、青の2本をそれと直交する線に合わせてください。一点鎖線がアイレベルです。Esc で終わります。</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>Open &amp;Recent</source>
        <translation>最近使ったプロジェクト(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>パネル (&amp;P)</translation>
    </message>
    <message>
        <source>Loo&amp;k At</source>
        <translation>表示内容 (&amp;K)</translation>
    </message>
    <message>
        <source>Onion Skin &amp;Drawings</source>
        <translation>オニオンスキンの枚数(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Backdrop</source>
        <translation>下地(&amp;B)</translation>
    </message>
    <message>
        <source>Preview &amp;Resolution</source>
        <translation>プレビュー解像度(&amp;R)</translation>
    </message>
    <message>
        <source>Background Picture</source>
        <translation>背景画像</translation>
    </message>
    <message>
        <source>Checker</source>
        <translation>チェック柄</translation>
    </message>
    <message>
        <source>Middle Grey</source>
        <translation>中間グレー</translation>
    </message>
    <message>
        <source>White</source>
        <translation>白</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>黒背景</translation>
    </message>
    <message>
        <source>Automatic: Lower While Dragging</source>
        <translation>自動：ドラッグ中だけ下げる</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>フル</translation>
    </message>
    <message>
        <source>Half</source>
        <translation>1/2</translation>
    </message>
    <message>
        <source>Quarter</source>
        <translation>1/4</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>言語(&amp;L)</translation>
    </message>
    <message>
        <source>System Default</source>
        <translation>システムの設定</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>キー(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Drawings</source>
        <translation>セル(&amp;D)</translation>
    </message>
    <message>
        <source>Fi&amp;gure</source>
        <translation>キャラクター(&amp;G)</translation>
    </message>
    <message>
        <source>La&amp;yer</source>
        <translation>レイヤー(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>セット(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Timeline Shows</source>
        <translation>タイムラインの表示 (&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Playback</source>
        <translation>再生(&amp;P)</translation>
    </message>
    <message>
        <source>La&amp;bel</source>
        <translation>ラベル(&amp;B)</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>ファイル(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>&apos;{path_suffix}&apos; is not a picture format that can be read</source>
        <translation>「{path_suffix}」は読み込める画像形式ではありません</translation>
    </message>
    <message>
        <source>&apos;{pattern_suffix}&apos; is not a picture format that can be read</source>
        <translation>「{pattern_suffix}」は読み込める画像形式ではありません</translation>
    </message>
    <message>
        <source>&apos;{suffix}&apos; is not a picture format that can be read</source>
        <translation>「{suffix}」は読み込める画像形式ではありません</translation>
    </message>
    <message>
        <source>, which needs layered frames,</source>
        <translation>（レイヤー付きの書き出しが必要）</translation>
    </message>
    <message>
        <source>0 rounds toward a disc on the ground, 1 toward the shadow&apos;s own long ellipse.</source>
        <translation>0 で地面上の円へ、1 で影そのものの細長い楕円へ近づく。</translation>
    </message>
    <message>
        <source>0 takes the waves as they are set; any other whole number varies them, always in the same way.</source>
        <translation>0 で設定どおりの波。ほかの整数では、その数ごとに決まった変化を付ける。</translation>
    </message>
    <message>
        <source>1 fades evenly, more fades early, less fades late.</source>
        <translation>1 で均一、大きいと早く、小さいと遅く薄れる。</translation>
    </message>
    <message>
        <source>3-D set</source>
        <translation>3Dセット</translation>
    </message>
    <message>
        <source>A lamp at a position, or the sun in a direction.</source>
        <translation>位置を持つライト、または方向だけの太陽。</translation>
    </message>
    <message>
        <source>A point of the ground line, where the ground meets the drawing.</source>
        <translation>地面がセルと交わる接地ライン上の点。</translation>
    </message>
    <message>
        <source>After Effects has no composition of {frame_rate} frames a second</source>
        <translation>After Effects では毎秒 {frame_rate} フレームのコンポジションを作れません</translation>
    </message>
    <message>
        <source>After Effects has no composition of {length_frames} frames</source>
        <translation>After Effects では {length_frames} フレームのコンポジションを作れません</translation>
    </message>
    <message>
        <source>After Effects has no composition of {width_px}x{height_px} px</source>
        <translation>After Effects では {width_px}x{height_px} px のコンポジションを作れません</translation>
    </message>
    <message>
        <source>Anchor</source>
        <translation>基準点</translation>
    </message>
    <message>
        <source>Angle between drawing and ground; 90 is seen edge-on, less is seen from higher.</source>
        <translation>セル面と地面の角度。90 で真横、小さいほど上から見下ろす。</translation>
    </message>
    <message>
        <source>At this distance from the feet the shadow has faded away; 0 does not fade.</source>
        <translation>足元からこの距離で影が消える。0 で消えない。</translation>
    </message>
    <message>
        <source>At this distance from the feet the shadow has the tip colour; 0 keeps one colour.</source>
        <translation>足元からこの距離で先端の色になる。0 で一色のまま。</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>合成モード</translation>
    </message>
    <message>
        <source>Blocks light</source>
        <translation>光をさえぎる</translation>
    </message>
    <message>
        <source>Body tilt</source>
        <translation>体の傾き</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>箱</translation>
    </message>
    <message>
        <source>Canvas px at the depth where the piece stands; a sphere is as high as it is wide.</source>
        <translation>セットが立つ奥行きでの画面上の px。球では使わない。</translation>
    </message>
    <message>
        <source>Canvas px at the depth where the piece stands; of a cylinder or a sphere the diameter.</source>
        <translation>セットが立つ奥行きでの画面上の px。円柱と球では直径。</translation>
    </message>
    <message>
        <source>Casts a shadow</source>
        <translation>影を落とす</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>クレイ</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Colour of the shadow that set pieces cast, sRGB.</source>
        <translation>セットが落とす影の色（sRGB）。</translation>
    </message>
    <message>
        <source>Colour of the shadow, sRGB.</source>
        <translation>影の色（sRGB）。</translation>
    </message>
    <message>
        <source>Colour toward the tip, where a tip distance is set; sRGB.</source>
        <translation>先端の距離を設定したときの先端の色（sRGB）。</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>円柱</translation>
    </message>
    <message>
        <source>Declination</source>
        <translation>地面の角度</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>奥行き</translation>
    </message>
    <message>
        <source>Direction of the sun around the ground; 0 stands on the viewer&apos;s side.</source>
        <translation>太陽の方位角。0 で手前側。</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Drawn as</source>
        <translation>表示方法</translation>
    </message>
    <message>
        <source>Edge of the floor, running away</source>
        <translation>奥へ向かう床の線</translation>
    </message>
    <message>
        <source>Edge of the floor, square to it</source>
        <translation>直交する床の線</translation>
    </message>
    <message>
        <source>Elongation</source>
        <translation>長さの維持</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>フェード</translation>
    </message>
    <message>
        <source>Fade curve</source>
        <translation>フェードの曲線</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>視野角</translation>
    </message>
    <message>
        <source>Flat ground</source>
        <translation>平らな地面</translation>
    </message>
    <message>
        <source>From crest to crest on the ground.</source>
        <translation>地面上での山から山までの長さ。</translation>
    </message>
    <message>
        <source>From front to back on the ground, canvas px at the depth where the piece stands: of boxes, steps and ramps.</source>
        <translation>地面上の手前から奥までの長さ。箱・階段・スロープで使う。</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Ground position</source>
        <translation>地面の位置</translation>
    </message>
    <message>
        <source>Ground roll</source>
        <translation>地面の回転</translation>
    </message>
    <message>
        <source>Grounding point {number}</source>
        <translation>接地点 {number}</translation>
    </message>
    <message>
        <source>Grounding points</source>
        <translation>接地点</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>拡張</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Height of the sun over the ground; a low sun throws long shadows.</source>
        <translation>地面からの太陽の高度。低いほど影が長い。</translation>
    </message>
    <message>
        <source>Horizon</source>
        <translation>アイレベル（地平線）</translation>
    </message>
    <message>
        <source>How an imported set is drawn: not at all, as a wireframe in the window only, or as clay in composites too.</source>
        <translation>読み込んだセットの表示。ワイヤーフレームは画面のみ、クレイは合成にも入る。</translation>
    </message>
    <message>
        <source>How far a wall leans back; below 0 it leans over its front.</source>
        <translation>壁を奥へ倒す角度。負の値で手前へ倒れる。</translation>
    </message>
    <message>
        <source>How far the crests go in a frame.</source>
        <translation>1 コマで波が進む距離。</translation>
    </message>
    <message>
        <source>How far the shape is rounded toward an ellipse; its edge stays crisp and its area stays the same.</source>
        <translation>影の形を楕円へ近づける度合い。輪郭はくっきりしたまま、面積も変わらない。</translation>
    </message>
    <message>
        <source>How far the waves move the shadow; 0 is no wave.</source>
        <translation>波が影を動かす量。0 で波なし。</translation>
    </message>
    <message>
        <source>How many steps there are; taken as a whole number.</source>
        <translation>階段の段数（整数に丸める）。</translation>
    </message>
    <message>
        <source>How much wider the edge grows with every px of distance from the feet.</source>
        <translation>足元から 1px 離れるごとにエッジが広がる量。</translation>
    </message>
    <message>
        <source>How the shadow lies on what is under it.</source>
        <translation>影を下の画像に重ねる方法。</translation>
    </message>
    <message>
        <source>How the shadow that set pieces cast lies on what is under it.</source>
        <translation>セットの影を下の画像に重ねる方法。</translation>
    </message>
    <message>
        <source>In the set</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Lamp&apos;s foot</source>
        <translation>ライトの足元</translation>
    </message>
    <message>
        <source>Lean</source>
        <translation>傾斜</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Light position</source>
        <translation>ライトの位置</translation>
    </message>
    <message>
        <source>Matte</source>
        <translation>マット</translation>
    </message>
    <message>
        <source>Moves the outline outward, or inward below 0.</source>
        <translation>輪郭を外側へ広げる。負の値で縮める。</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>乗算</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>通常</translation>
    </message>
    <message>
        <source>Not at all</source>
        <translation>表示しない</translation>
    </message>
    <message>
        <source>Of an imported set: canvas px for one unit of the file, at the depth where it stands.</source>
        <translation>読み込んだセットの大きさ。ファイルの1単位が、立つ奥行きで何 px か。</translation>
    </message>
    <message>
        <source>On ones</source>
        <translation>1コマ打ち</translation>
    </message>
    <message>
        <source>On ones the shadow moves every frame; with the exposures it waits for the next drawing.</source>
        <translation>ones は毎コマ動き、exposures は次のセルまで動かない。</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Opacity of the shadow that set pieces cast, 0 to 1.</source>
        <translation>セットが落とす影の不透明度（0〜1）。</translation>
    </message>
    <message>
        <source>Opacity of the shadow, 0 to 1.</source>
        <translation>影の不透明度（0〜1）。</translation>
    </message>
    <message>
        <source>OpenGL without a display needs libEGL (Debian package libegl1): {error}</source>
        <translation>ディスプレイなしの OpenGL には libEGL（Debian のパッケージ libegl1）が要ります：{error}</translation>
    </message>
    <message>
        <source>OpenGL without a window system is available on Linux only</source>
        <translation>ウィンドウシステムなしの OpenGL は Linux でしか使えません</translation>
    </message>
    <message>
        <source>Over this distance from the feet the rounding grows to its full strength; 0 rounds everywhere alike.</source>
        <translation>足元からこの距離までに単純化が強まる。0 なら全体に同じ強さ。</translation>
    </message>
    <message>
        <source>Over this distance from the feet the waves grow to their full strength; 0 moves the feet too.</source>
        <translation>足元からこの距離までに波が強まる。0 なら足元も揺れる。</translation>
    </message>
    <message>
        <source>Overhead radius</source>
        <translation>真上ライトの範囲</translation>
    </message>
    <message>
        <source>Penumbra</source>
        <translation>半影</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>坂</translation>
    </message>
    <message>
        <source>Receives</source>
        <translation>影を受ける</translation>
    </message>
    <message>
        <source>Receives shadows</source>
        <translation>影を受ける</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>スケール</translation>
    </message>
    <message>
        <source>Set piece</source>
        <translation>セット</translation>
    </message>
    <message>
        <source>Set shadow blend</source>
        <translation>セットの影の合成モード</translation>
    </message>
    <message>
        <source>Set shadow colour</source>
        <translation>セットの影の色</translation>
    </message>
    <message>
        <source>Set shadow opacity</source>
        <translation>セットの影の不透明度</translation>
    </message>
    <message>
        <source>Shadow timing</source>
        <translation>影のコマ打ち</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形</translation>
    </message>
    <message>
        <source>Simplification</source>
        <translation>単純化フィルター</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>単純化</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>ぼかし</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>ソリッド</translation>
    </message>
    <message>
        <source>Solid: half-opaque and more casts fully; translucent: alpha casts as it is (smoke, glass).</source>
        <translation>solid は半透明以上がすべて影、translucent はアルファのまま影（煙・ガラス）。</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>球</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>段数</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>太陽</translation>
    </message>
    <message>
        <source>Sun azimuth</source>
        <translation>太陽の方位</translation>
    </message>
    <message>
        <source>Sun elevation</source>
        <translation>太陽の高さ</translation>
    </message>
    <message>
        <source>The point of an imported set, in the units of its file, that stands on the ground at the piece&apos;s place.</source>
        <translation>セットの位置で地面に立つ点（ファイルの単位）。</translation>
    </message>
    <message>
        <source>The point of the ground on which the middle of the piece stands, as it is seen on the canvas.</source>
        <translation>セットの中心が立つ地面上の点（画面上の位置）。</translation>
    </message>
    <message>
        <source>Tip colour</source>
        <translation>先端の色</translation>
    </message>
    <message>
        <source>Tip distance</source>
        <translation>先端の距離</translation>
    </message>
    <message>
        <source>Tip of the shadow</source>
        <translation>影の先</translation>
    </message>
    <message>
        <source>Translucent</source>
        <translation>半透明</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Turn about the vertical of the ground; at 0 the front is the viewer&apos;s side.</source>
        <translation>地面に垂直な軸まわりの回転。0 で正面が手前を向く。</translation>
    </message>
    <message>
        <source>Turn of the body about the vertical; measured, not set, with two grounding points.</source>
        <translation>垂直軸まわりの体の向き。接地点が二つあるときは自動で決まる。</translation>
    </message>
    <message>
        <source>Turn of the ground line in the picture.</source>
        <translation>画面内での接地ラインの傾き。</translation>
    </message>
    <message>
        <source>Under the background</source>
        <translation>背景の下</translation>
    </message>
    <message>
        <source>Up axis</source>
        <translation>上方向の軸</translation>
    </message>
    <message>
        <source>Vertical field of view of the camera; 0 is orthographic.</source>
        <translation>カメラの垂直視野角。0 で平行投影。</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>Wave anchor</source>
        <translation>波の固定</translation>
    </message>
    <message>
        <source>Wave seed</source>
        <translation>波の乱数</translation>
    </message>
    <message>
        <source>Wave {number}</source>
        <translation>波{number}</translation>
    </message>
    <message>
        <source>Wave {number} amplitude</source>
        <translation>波{number} 振幅</translation>
    </message>
    <message>
        <source>Wave {number} direction</source>
        <translation>波{number} 方向</translation>
    </message>
    <message>
        <source>Wave {number} length</source>
        <translation>波{number} 波長</translation>
    </message>
    <message>
        <source>Wave {number} speed</source>
        <translation>波{number} 速さ</translation>
    </message>
    <message>
        <source>Waves</source>
        <translation>波フィルター</translation>
    </message>
    <message>
        <source>What the piece is; it keeps its place and its measures.</source>
        <translation>セットの形。位置と寸法はそのまま。</translation>
    </message>
    <message>
        <source>Where the character touches the ground; with two or more the card is folded through them.</source>
        <translation>キャラクターが地面に触れる点。二つ以上でセル面が点を通って曲がる。</translation>
    </message>
    <message>
        <source>Where the crests go on the ground; 0 is to the right, 90 toward the viewer.</source>
        <translation>地面上で波が進む向き。0 で右、90 で手前。</translation>
    </message>
    <message>
        <source>Where the lamp stands; z &gt; 0 is on the viewer&apos;s side and throws shadows behind the character.</source>
        <translation>ライトの位置。z が正なら手前側にあり、影は奥へ落ちる。</translation>
    </message>
    <message>
        <source>Whether an imported set is drawn under the background picture rather than over it.</source>
        <translation>読み込んだセットを背景の上ではなく下に描く。</translation>
    </message>
    <message>
        <source>Whether its own shadow is drawn, on itself, the ground and the other pieces; it then blocks light too.</source>
        <translation>自身の影を地面やほかのセットに描くか。オンなら光もさえぎる。</translation>
    </message>
    <message>
        <source>Whether shadows fall on the flat ground; off where an imported set is all there is.</source>
        <translation>平らな地面に影を落とすか。読み込んだセットだけを使うときはオフ。</translation>
    </message>
    <message>
        <source>Whether the characters&apos; shadows end where this piece takes the light.</source>
        <translation>このセットが光をさえぎる場所でキャラクターの影を切るか。</translation>
    </message>
    <message>
        <source>Whether the characters&apos; shadows fall on it; it hides what is behind it in either case.</source>
        <translation>キャラクターの影がこのセットに落ちるか。オフでも後ろの影は隠す。</translation>
    </message>
    <message>
        <source>Whether the layer and its shadow are shown and rendered.</source>
        <translation>レイヤーとその影を表示・書き出しするか。</translation>
    </message>
    <message>
        <source>Whether the piece is there at all.</source>
        <translation>このセットを使うかどうか。</translation>
    </message>
    <message>
        <source>Whether the shadow lies on water; off keeps the values and leaves them out.</source>
        <translation>影を水面に落とすか。オフでも値は残る。</translation>
    </message>
    <message>
        <source>Whether the shadows of the other characters fall on this one, where the light meets them first.</source>
        <translation>ほかのキャラクターの影がこのキャラクターに落ちるか（ライトから見て手前にいるキャラクターの影だけ）。</translation>
    </message>
    <message>
        <source>Whether the shape is simplified; off keeps the values and leaves them out.</source>
        <translation>単純化を使うか。オフでも値は残る。</translation>
    </message>
    <message>
        <source>Which axis of the file of an imported set points up.</source>
        <translation>読み込んだセットのファイルで上を向く軸。</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Width of the edge; 0 is a crisp cel edge.</source>
        <translation>エッジの幅。0 でくっきりしたセルのエッジ。</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>ワイヤーフレーム</translation>
    </message>
    <message>
        <source>With the drawings</source>
        <translation>セルに合わせる</translation>
    </message>
    <message>
        <source>Within this distance over the character the lamp is spread into four, so that light from straight above still casts.</source>
        <translation>キャラクターの真上でこの距離以内のライトを四つに分け、真上の光でも影を落とす。</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>a box with pixels in it</source>
        <translation>画素のある枠</translation>
    </message>
    <message>
        <source>a camera moves for {frames} frames, more than the {most_frames} that are read</source>
        <translation>カメラの動きが {frames} フレームあり、読み込める {most_frames} フレームを超えています</translation>
    </message>
    <message>
        <source>a canvas of {width} × {height} px, as the pictures have it, is larger than {most_side_px} px; please give a size</source>
        <translation>画像から決まるキャンバス {width} × {height} px は {most_side_px} px より大きすぎます。大きさを指定してください</translation>
    </message>
    <message>
        <source>a colour such as &quot;#20203A&quot;</source>
        <translation>&quot;#20203A&quot; のような色</translation>
    </message>
    <message>
        <source>a component</source>
        <translation>成分番号</translation>
    </message>
    <message>
        <source>a corner lies more than {farthest:g} units away</source>
        <translation>{farthest:g} 単位より遠い頂点があります</translation>
    </message>
    <message>
        <source>a farm renders a saved project; save this one first</source>
        <translation>レンダーファームは保存したプロジェクトをレンダリングします。先に保存してください</translation>
    </message>
    <message>
        <source>a frame</source>
        <translation>フレーム番号</translation>
    </message>
    <message>
        <source>a frame rate such as &quot;24&quot; or &quot;24000/1001&quot;</source>
        <translation>&quot;24&quot; や &quot;24000/1001&quot; のようなフレームレート</translation>
    </message>
    <message>
        <source>a height from 1 to {tallest_px:g} px</source>
        <translation>1～{tallest_px:g} px の高さ</translation>
    </message>
    <message>
        <source>a key&apos;s component cannot be changed</source>
        <translation>キーの成分は変えられません</translation>
    </message>
    <message>
        <source>a layer cannot be named {name!r}: a name is 1 to 200 printable characters</source>
        <translation>レイヤーの名前を {name!r} にはできません。名前は表示できる文字 1～200 文字です</translation>
    </message>
    <message>
        <source>a layered frame holds what a composite is made of; ask for one of the two</source>
        <translation>レイヤー付きフレームには合成の中身がすべて入っています。どちらか一方を選んでください</translation>
    </message>
    <message>
        <source>a line is too short, or lies on the other of its colour</source>
        <translation>線が短すぎるか、同じ色の線と重なっています</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>a list of at most {most_points} points [[x, y], …] in px</source>
        <translation>最大 {most_points} 個の点のリスト [[x, y], …]（px）</translation>
    </message>
    <message>
        <source>a marker cannot lie on frame {frame} for {duration_frames} frames</source>
        <translation>フレーム {frame} から {duration_frames} フレームのマーカーは置けません</translation>
    </message>
    <message>
        <source>a name of 1 to 80 printable characters</source>
        <translation>表示できる文字 1～80 文字の名前</translation>
    </message>
    <message>
        <source>a note needs words and a frame from 1 on</source>
        <translation>メモには言葉と 1 以上のフレームが要ります</translation>
    </message>
    <message>
        <source>a number from {low:g} to {high:g}</source>
        <translation>{low:g} から {high:g} までの数</translation>
    </message>
    <message>
        <source>a number from {low:g} to {high:g}{unit}</source>
        <translation>{low:g} から {high:g}{unit} までの数</translation>
    </message>
    <message>
        <source>a part of its path is not a folder</source>
        <translation>パスの途中がフォルダーではありません</translation>
    </message>
    <message>
        <source>a path has 1 to {most} characters</source>
        <translation>パスは 1～{most} 文字です</translation>
    </message>
    <message>
        <source>a path on a drive starts at its root</source>
        <translation>ドライブのパスはルートから始めてください</translation>
    </message>
    <message>
        <source>a picture of {width_px}x{height_px} px is over this graphics driver&apos;s {limit} px</source>
        <translation>{width_px}x{height_px} px の画像は、このグラフィックスドライバーの上限 {limit} px を超えています</translation>
    </message>
    <message>
        <source>a printable name</source>
        <translation>表示できる名前</translation>
    </message>
    <message>
        <source>a project may not name files on the network</source>
        <translation>プロジェクトはネットワーク上のファイルを指せません</translation>
    </message>
    <message>
        <source>a set has at most {most_pieces} pieces</source>
        <translation>大道具は最大 {most_pieces} 個までです</translation>
    </message>
    <message>
        <source>a set piece cannot be named {name!r}: a name is 1 to 200 printable characters</source>
        <translation>大道具の名前を {name!r} にはできません。名前は表示できる文字 1～200 文字です</translation>
    </message>
    <message>
        <source>a set piece cannot be named {name!r}: set.{name} is the shadow of the whole set</source>
        <translation>大道具の名前を {name!r} にはできません。set.{name} は大道具全体の影です</translation>
    </message>
    <message>
        <source>a set piece has no property {each!r}</source>
        <translation>大道具にプロパティ {each!r} はありません</translation>
    </message>
    <message>
        <source>a size is given by two different points of the set and a length over 0</source>
        <translation>大きさは、セットの異なる2点と 0 より大きい長さで決まります</translation>
    </message>
    <message>
        <source>a speed</source>
        <translation>速度の数</translation>
    </message>
    <message>
        <source>a style cannot be named {name!r}: a name is 1 to 80 letters and digits</source>
        <translation>スタイルの名前を {name!r} にはできません。名前は文字と数字で 1～80 文字です</translation>
    </message>
    <message>
        <source>a switch or choice can only be held</source>
        <translation>スイッチや選択肢のキーは停止だけです</translation>
    </message>
    <message>
        <source>a task has 1 to {most_chunk} frames, not {chunk}</source>
        <translation>1 つのタスクは 1～{most_chunk} フレームです。{chunk} にはできません</translation>
    </message>
    <message>
        <source>a text of {count} characters is longer than the {most_text_characters} allowed</source>
        <translation>{count} 文字の文は上限の {most_text_characters} 文字を超えています</translation>
    </message>
    <message>
        <source>a text of {least} to {most} characters</source>
        <translation>{least}～{most} 文字のテキスト</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>値の数</translation>
    </message>
    <message>
        <source>a whole number from {low} to {high}</source>
        <translation>{low} から {high} までの整数</translation>
    </message>
    <message>
        <source>alpha is full everywhere: the whole frame would cast a shadow</source>
        <translation>アルファが全面不透明です。画面全体が影を落とします</translation>
    </message>
    <message>
        <source>an export preset is named by 1 to {most_name} printable characters, not {name!r}</source>
        <translation>書き出しプリセットの名前は 1〜{most_name} 文字の表示できる文字です（{name!r} は使えません）</translation>
    </message>
    <message>
        <source>an influence</source>
        <translation>影響の数</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>オブジェクト</translation>
    </message>
    <message>
        <source>cannot be written: it reads back with other frames than it got</source>
        <translation>書き出せません：読み戻したフレームが渡したものと違います</translation>
    </message>
    <message>
        <source>cannot be written: {cause}</source>
        <translation>書き込めません：{cause}</translation>
    </message>
    <message>
        <source>cannot be written: {error}</source>
        <translation>書き込めません：{error}</translation>
    </message>
    <message>
        <source>canvas: a cut of {length_frames} frames is not within 1 to 1000000</source>
        <translation>canvas：{length_frames} フレームの尺は 1～1000000 の範囲にありません</translation>
    </message>
    <message>
        <source>canvas: {frame_rate} frames a second is not within 0 to 1000</source>
        <translation>canvas：毎秒 {frame_rate} フレームは 0～1000 の範囲にありません</translation>
    </message>
    <message>
        <source>canvas: {width_px}x{height_px} is not within 1x1 to 16384x16384 px</source>
        <translation>canvas：{width_px}x{height_px} は 1x1～16384x16384 px の範囲にありません</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>一定値</translation>
    </message>
    <message>
        <source>deep and volume pictures cannot be read</source>
        <translation>ディープ画像とボリューム画像は読み込めません</translation>
    </message>
    <message>
        <source>frame {after} does not come after frame {before}</source>
        <translation>フレーム {after} はフレーム {before} より後ではありません</translation>
    </message>
    <message>
        <source>frame {frame}</source>
        <translation>フレーム {frame}</translation>
    </message>
    <message>
        <source>frame {frame} does not come after frame {frame_2}</source>
        <translation>フレーム {frame} はフレーム {frame_2} より後ではありません</translation>
    </message>
    <message>
        <source>frame {frame} is not in the cut, which has frames 1-{length}</source>
        <translation>フレーム {frame} はカットにありません。カットは 1-{length} フレームです</translation>
    </message>
    <message>
        <source>frame {frame} needs {count} rows, one for each component</source>
        <translation>フレーム {frame} には成分ごとに {count} 行が要ります</translation>
    </message>
    <message>
        <source>frame {last} does not come after frame {first}</source>
        <translation>フレーム {last} はフレーム {first} より後ではありません</translation>
    </message>
    <message>
        <source>frames cannot be written as {format!r}{hint} only as {suffixes}</source>
        <translation>フレームは {format!r}{hint} では書き出せません。{suffixes} を選んでください</translation>
    </message>
    <message>
        <source>frames {text!r}: {part!r} is neither a frame such as 12 nor a range such as 1-48</source>
        <translation>フレーム {text!r}：{part!r} は 12 のようなフレームでも 1-48 のような範囲でもありません</translation>
    </message>
    <message>
        <source>frames {text!r}: {part!r} must count upward from frame 1</source>
        <translation>フレーム {text!r}：{part!r} はフレーム 1 から昇順に書いてください</translation>
    </message>
    <message>
        <source>it cannot be a file name</source>
        <translation>ファイル名として使えません</translation>
    </message>
    <message>
        <source>it cannot be read as USD: the file is damaged</source>
        <translation>USD として読み込めません：ファイルが壊れています</translation>
    </message>
    <message>
        <source>it cannot be read as a set: the file is damaged or not what its name says</source>
        <translation>セットとして読み込めません：ファイルが壊れているか、拡張子と中身が違います</translation>
    </message>
    <message>
        <source>it cannot be the name of a file</source>
        <translation>ファイル名として使えません</translation>
    </message>
    <message>
        <source>it does not exist</source>
        <translation>見つかりません</translation>
    </message>
    <message>
        <source>it has more than {most_nodes} nodes</source>
        <translation>ノードが {most_nodes} 個を超えています</translation>
    </message>
    <message>
        <source>it has no pixels</source>
        <translation>画素がありません</translation>
    </message>
    <message>
        <source>it has vector shapes that cannot be drawn</source>
        <translation>描画できないベクターシェイプがあります</translation>
    </message>
    <message>
        <source>it has {corners} corners of triangles, too many to work with</source>
        <translation>三角形の頂点が {corners} 個あり、多すぎて扱えません</translation>
    </message>
    <message>
        <source>it has {count} items, not {least} to {most}</source>
        <translation>項目が {count} 個あります。{least}～{most} 個でなければなりません</translation>
    </message>
    <message>
        <source>it has {count} items, not {most}</source>
        <translation>項目が {count} 個あります。{most} 個でなければなりません</translation>
    </message>
    <message>
        <source>it has {count} triangles, more than the {most} that can be worked with</source>
        <translation>三角形が {count} 個あり、扱える {most} 個を超えています</translation>
    </message>
    <message>
        <source>it has {total} triangles, more than the {most_triangles} that can be worked with</source>
        <translation>三角形が {total} 個あり、扱える {most_triangles} 個を超えています</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>フォルダーです</translation>
    </message>
    <message>
        <source>it is compressed ({name}): please export it without compression</source>
        <translation>圧縮されています（{name}）。圧縮なしで書き出し直してください</translation>
    </message>
    <message>
        <source>it is cut off</source>
        <translation>途中で切れています</translation>
    </message>
    <message>
        <source>it is damaged: a buffer in it is not base64 text</source>
        <translation>壊れています：内蔵バッファが base64 ではありません</translation>
    </message>
    <message>
        <source>it is damaged: a buffer is shorter than it should be</source>
        <translation>壊れています：バッファが短すぎます</translation>
    </message>
    <message>
        <source>it is damaged: a corner is not a number</source>
        <translation>壊れています：頂点の座標が数値ではありません</translation>
    </message>
    <message>
        <source>it is damaged: a node has two parents</source>
        <translation>壊れています：ひとつのノードに親が二つあります</translation>
    </message>
    <message>
        <source>it is damaged: a triangle names a missing corner</source>
        <translation>壊れています：三角形が存在しない頂点を参照しています</translation>
    </message>
    <message>
        <source>it is damaged: corners are not named by whole numbers</source>
        <translation>壊れています：頂点番号が整数ではありません</translation>
    </message>
    <message>
        <source>it is damaged: it refers to more numbers than it holds</source>
        <translation>壊れています：持っている以上の数値を参照しています</translation>
    </message>
    <message>
        <source>it is damaged: its nodes form an endless loop</source>
        <translation>壊れています：ノードの親子関係が終わりません</translation>
    </message>
    <message>
        <source>it is damaged: it refers to numbers that are missing</source>
        <translation>壊れています：存在しない数値を参照しています</translation>
    </message>
    <message>
        <source>it is damaged: there is no {name}[{index}]</source>
        <translation>壊れています：{name}[{index}] がありません</translation>
    </message>
    <message>
        <source>it is glTF {version}; only glTF 2 is read</source>
        <translation>glTF {version} です。読み込めるのは glTF 2 だけです</translation>
    </message>
    <message>
        <source>it is larger than can be read</source>
        <translation>大きすぎて読み込めません</translation>
    </message>
    <message>
        <source>it is larger than can be read at the layer {layer!r}</source>
        <translation>レイヤー {layer!r} が大きすぎて読み込めません</translation>
    </message>
    <message>
        <source>it is larger than {megabytes} MB, too large for a set</source>
        <translation>{megabytes} MB を超えており、セットとして大きすぎます</translation>
    </message>
    <message>
        <source>it is larger than {megabytes} MB, too large for kept work</source>
        <translation>{megabytes} MB より大きく、退避した作業のファイルではありません</translation>
    </message>
    <message>
        <source>it is larger than {megabytes} MB, too large for a project</source>
        <translation>{megabytes} MB より大きく、プロジェクトではありません</translation>
    </message>
    <message>
        <source>it is larger than {megabytes} MB, too large for a timesheet</source>
        <translation>{megabytes} MB より大きく、タイムシートではありません</translation>
    </message>
    <message>
        <source>it is neither a file nor a folder</source>
        <translation>ファイルでもフォルダーでもありません</translation>
    </message>
    <message>
        <source>it is nested too deep</source>
        <translation>入れ子が深すぎます</translation>
    </message>
    <message>
        <source>it is not a glTF 2 file</source>
        <translation>glTF 2 のファイルではありません</translation>
    </message>
    <message>
        <source>it is not a complete glTF file</source>
        <translation>完全な glTF ファイルではありません</translation>
    </message>
    <message>
        <source>it is not a complete glTF file: {name!r} is not a list</source>
        <translation>完全な glTF ファイルではありません：{name!r} がリストではありません</translation>
    </message>
    <message>
        <source>it is not UTF-8 text</source>
        <translation>UTF-8 のテキストではありません</translation>
    </message>
    <message>
        <source>it is not UTF-8 text (byte {start})</source>
        <translation>UTF-8 のテキストではありません（{start} バイト目）</translation>
    </message>
    <message>
        <source>it is not a Kagezou project</source>
        <translation>Kagezou のプロジェクトではありません</translation>
    </message>
    <message>
        <source>it is not a file</source>
        <translation>ファイルではありません</translation>
    </message>
    <message>
        <source>it is not a timesheet (XDTS, TDTS or STS)</source>
        <translation>タイムシート（XDTS、TDTS、STS）ではありません</translation>
    </message>
    <message>
        <source>it is not complete JSON text (line {lineno}, column {colno})</source>
        <translation>JSON として完全ではありません（{lineno} 行 {colno} 列）</translation>
    </message>
    <message>
        <source>it is not {wanted} but {inside}, whatever its name says</source>
        <translation>名前とちがい、中身は {wanted} ではなく {inside} 形式です</translation>
    </message>
    <message>
        <source>it is not {wanted}, whatever its name says</source>
        <translation>名前とちがい、中身は {wanted} 形式ではありません</translation>
    </message>
    <message>
        <source>it is too large for a style</source>
        <translation>スタイルのファイルとしては大きすぎます</translation>
    </message>
    <message>
        <source>it is too large for one</source>
        <translation>大きすぎます</translation>
    </message>
    <message>
        <source>it is too large for shortcuts</source>
        <translation>ショートカットのファイルとしては大きすぎます</translation>
    </message>
    <message>
        <source>it lasts {count} frames, more than the {most_frames} that are read</source>
        <translation>長さが {count} フレームあり、読み込める {most_frames} フレームを超えています</translation>
    </message>
    <message>
        <source>it names a device</source>
        <translation>デバイス名です</translation>
    </message>
    <message>
        <source>it names a drive of another computer</source>
        <translation>ほかのコンピューターのドライブを指しています</translation>
    </message>
    <message>
        <source>it names more than {most_commands} commands</source>
        <translation>コマンドが {most_commands} を超えています</translation>
    </message>
    <message>
        <source>it refers to {name!r} outside its own folder, which is not followed</source>
        <translation>フォルダーの外の {name!r} を参照しているため読み込みません</translation>
    </message>
    <message>
        <source>it would exceed the file size limit</source>
        <translation>ファイルサイズの上限を超えます</translation>
    </message>
    <message>
        <source>its buffers are larger than {megabytes} MB or too many</source>
        <translation>バッファが {megabytes} MB を超えているか、数が多すぎます</translation>
    </message>
    <message>
        <source>its description is larger than {megabytes} MB</source>
        <translation>記述部が {megabytes} MB を超えています</translation>
    </message>
    <message>
        <source>its folder does not exist</source>
        <translation>そのフォルダーがありません</translation>
    </message>
    <message>
        <source>its groups are nested too deep</source>
        <translation>グループの階層が深すぎます</translation>
    </message>
    <message>
        <source>its links lead in a circle</source>
        <translation>リンクが循環しています</translation>
    </message>
    <message>
        <source>its name is not valid text: please rename it</source>
        <translation>名前が正しい文字列ではありません。名前を変えてください</translation>
    </message>
    <message>
        <source>its name is too long</source>
        <translation>名前が長すぎます</translation>
    </message>
    <message>
        <source>its pixels cannot be decoded</source>
        <translation>画素を復号できません</translation>
    </message>
    <message>
        <source>layered frames cannot be written as {format!r}, only as psd or exr</source>
        <translation>レイヤー付きフレームは {format!r} では書き出せません。psd か exr を選んでください</translation>
    </message>
    <message>
        <source>layers.{layer}: an exposure names a missing drawing</source>
        <translation>layers.{layer}：セル指定に、ないセルが指定されています</translation>
    </message>
    <message>
        <source>layers.{layer}: exposures are out of order</source>
        <translation>layers.{layer}：セル指定の順序が正しくありません</translation>
    </message>
    <message>
        <source>layers: two layers have the same id</source>
        <translation>layers：2 つのレイヤーの ID が同じです</translation>
    </message>
    <message>
        <source>layers: two layers have the same name</source>
        <translation>layers：2 つのレイヤーの名前が同じです</translation>
    </message>
    <message>
        <source>linked: {name!r} cannot be the same for all layers</source>
        <translation>linked：{name!r} は全レイヤー共通にできません</translation>
    </message>
    <message>
        <source>linked: {name} is not the same for all layers</source>
        <translation>linked：{name} の値が全レイヤーで同じではありません</translation>
    </message>
    <message>
        <source>markers: markers are out of order</source>
        <translation>markers：マーカーの順序が正しくありません</translation>
    </message>
    <message>
        <source>more than {most_nodes} layers are in it</source>
        <translation>レイヤーが {most_nodes} 枚を超えています</translation>
    </message>
    <message>
        <source>more than {most_rows} drawings, exposures and keys</source>
        <translation>セルとセル指定とキーが合わせて {most_rows} を超えています</translation>
    </message>
    <message>
        <source>OpenGL 3.3 is not available without a display: on Debian and Ubuntu install libegl1 libgl1 libgl1-mesa-dri</source>
        <translation>ディスプレイなしでは OpenGL 3.3 を使えません。Debian と Ubuntu では libegl1 libgl1 libgl1-mesa-dri をインストールしてください</translation>
    </message>
    <message>
        <source>no alpha channel and no white: the whole frame would cast a shadow</source>
        <translation>アルファチャンネルも白もありません。画面全体が影を落とします</translation>
    </message>
    <message>
        <source>no alpha channel: pure white was taken as clear</source>
        <translation>アルファチャンネルがありません。純白を透明とみなしました</translation>
    </message>
    <message>
        <source>no file has such a name</source>
        <translation>そのような名前のファイルはありません</translation>
    </message>
    <message>
        <source>frame none is not in the cut, which has frames 1-{length}</source>
        <translation>フレームが指定されていません。カットは 1-{length} フレームです</translation>
    </message>
    <message>
        <source>there is no layer for the timesheet&apos;s column {track!r}</source>
        <translation>タイムシートの列 {track!r} に当たるレイヤーがありません</translation>
    </message>
    <message>
        <source>no space left on the disk</source>
        <translation>ディスクに空きがありません</translation>
    </message>
    <message>
        <source>Height {value} px</source>
        <translation>高さ {value} px</translation>
    </message>
    <message>
        <source>How much softer the shadow&apos;s edge becomes in a jump; at 1 by a quarter of the height over the ground.</source>
        <translation>ジャンプ中に影の縁がどれだけ柔らかくなるか。1 で地面からの高さの 4 分の 1 だけ広がります。</translation>
    </message>
    <message>
        <source>Islands and holes of the shadow that are smaller than this are left out.</source>
        <translation>これより小さい影の島や穴を省きます。</translation>
    </message>
    <message>
        <source>it is compressed with Draco, which needs the package DracoPy: {how}</source>
        <translation>Draco で圧縮されています。読むにはパッケージ DracoPy が要ります：{how}</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>notes: there is no property {property!r} of layer {layer_id!r}</source>
        <translation>notes：レイヤー {layer_id!r} にプロパティ {property!r} はありません</translation>
    </message>
    <message>
        <source>nothing runs together: there is no perspective in these lines</source>
        <translation>どの線も交わらず、パースがありません</translation>
    </message>
    <message>
        <source>one of {choices}</source>
        <translation>次のどれか：{choices}</translation>
    </message>
    <message>
        <source>one of {words}</source>
        <translation>次のどれか：{words}</translation>
    </message>
    <message>
        <source>one run of &apos;#&apos; is needed where the number stands</source>
        <translation>番号の位置に「#」の並びが 1 つ要ります</translation>
    </message>
    <message>
        <source>permission denied</source>
        <translation>アクセスする権限がありません</translation>
    </message>
    <message>
        <source>set: two pieces have the same id</source>
        <translation>set：2 つの大道具の ID が同じです</translation>
    </message>
    <message>
        <source>set: two pieces have the same name</source>
        <translation>set：2 つの大道具の名前が同じです</translation>
    </message>
    <message>
        <source>shadows for After Effects are {formats}, not {format!r}</source>
        <translation>After Effects 用の影は {formats} です。{format!r} にはできません</translation>
    </message>
    <message>
        <source>the OpenGL context cannot be used on this thread (EGL error {self})</source>
        <translation>このスレッドでは OpenGL コンテキストを使えません（EGL エラー {self}）</translation>
    </message>
    <message>
        <source>the STS timesheet has no frames</source>
        <translation>STS タイムシートにフレームがありません</translation>
    </message>
    <message>
        <source>the STS timesheet is cut off</source>
        <translation>STS タイムシートが途中で切れています</translation>
    </message>
    <message>
        <source>the STS timesheet is cut off: {columns} columns of {length} frames do not fit</source>
        <translation>STS タイムシートが途中で切れています。{columns} 列 × {length} フレームが入っていません</translation>
    </message>
    <message>
        <source>the camera {camera!r} is for a picture of {camera_aspect:.3f} to 1, the canvas is {aspect:.3f} to 1: the height was kept, the sides differ</source>
        <translation>カメラ {camera!r} の画面比は {camera_aspect:.3f}:1、キャンバスは {aspect:.3f}:1 です。縦を合わせたので左右の範囲が変わります</translation>
    </message>
    <message>
        <source>the camera {camera!r} moves for {camera_frames} frames, the cut has {cut_frames}</source>
        <translation>カメラ {camera!r} は {camera_frames} フレーム動きますが、カットは {cut_frames} フレームです</translation>
    </message>
    <message>
        <source>the camera {camera!r} sees nothing of the set where the character stands</source>
        <translation>カメラ {camera!r} からは、キャラクターが立つ場所にセットが見えません</translation>
    </message>
    <message>
        <source>the camera {camera!r} sees the ground at {declination:.1f}° on frame {frame}; it can be followed from {low:g}° to {high:g}°</source>
        <translation>カメラ {camera!r} はフレーム {frame} で地面を {declination:.1f}° に見ています。合わせられるのは {low:g}° から {high:g}° です</translation>
    </message>
    <message>
        <source>the camera {made!r} in it makes no sense</source>
        <translation>カメラ {made!r} の値が正しくありません</translation>
    </message>
    <message>
        <source>the card is seen edge-on and has no picture for the depth map</source>
        <translation>カードを真横から見ているため、深度マップに像がありません</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>ディスクが読み取り専用です</translation>
    </message>
    <message>
        <source>the disk quota is used up</source>
        <translation>ディスクの割り当てを使い切りました</translation>
    </message>
    <message>
        <source>the disk reports an input/output error</source>
        <translation>ディスクの入出力エラーです</translation>
    </message>
    <message>
        <source>the drawings of {layer!r} are not a sequence without gaps, so they were copied</source>
        <translation>{layer!r} のセルは番号の続いた連番ではないため、コピーしました</translation>
    </message>
    <message>
        <source>the drawings of {layer!r} have no alpha, so they were copied with it</source>
        <translation>{layer!r} のセルにはアルファがないため、アルファ付きでコピーしました</translation>
    </message>
    <message>
        <source>the file is cut short</source>
        <translation>ファイルが途中で切れています</translation>
    </message>
    <message>
        <source>the file is damaged (a checksum is wrong)</source>
        <translation>ファイルが壊れています（チェックサムが合いません）</translation>
    </message>
    <message>
        <source>the file is damaged (an impossible header)</source>
        <translation>ファイルが壊れています（ヘッダーの値がありえません）</translation>
    </message>
    <message>
        <source>the file is damaged (it has no header)</source>
        <translation>ファイルが壊れています（ヘッダーがありません）</translation>
    </message>
    <message>
        <source>the file is damaged at the layer {layer!r} or of an unknown kind ({cause})</source>
        <translation>レイヤー {layer!r} のところでファイルが壊れているか、未知の種類です（{cause}）</translation>
    </message>
    <message>
        <source>the file is damaged or of an unknown kind ({cause})</source>
        <translation>ファイルが壊れているか、未知の種類です（{cause}）</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>ファイルが空です</translation>
    </message>
    <message>
        <source>the graphics driver cannot draw a picture of {width_px}x{height_px} px ({form})</source>
        <translation>グラフィックスドライバーは {width_px}x{height_px} px の画像を描けません（{form}）</translation>
    </message>
    <message>
        <source>the graphics driver failed while {doing}: {error}</source>
        <translation>グラフィックスドライバーが失敗しました（{doing}）：{error}</translation>
    </message>
    <message>
        <source>the graphics driver gives no OpenGL context beside the window</source>
        <translation>グラフィックスドライバーからウィンドウの外の OpenGL コンテキストを得られません</translation>
    </message>
    <message>
        <source>the graphics driver offers OpenGL {version} ({renderer}); Kagezou needs 3.3: update the driver</source>
        <translation>グラフィックスドライバーの OpenGL は {version}（{renderer}）です。Kagezou には 3.3 が要ります。ドライバーを更新してください</translation>
    </message>
    <message>
        <source>the graphics driver offers OpenGL {version}; Kagezou needs 3.3: update the driver</source>
        <translation>グラフィックスドライバーの OpenGL は {version} です。Kagezou には 3.3 が要ります。ドライバーを更新してください</translation>
    </message>
    <message>
        <source>the graphics driver refuses {name}: {glgetprograminfolog}</source>
        <translation>グラフィックスドライバーが {name} を受け付けません：{glgetprograminfolog}</translation>
    </message>
    <message>
        <source>the graphics driver refuses {name}: {log}</source>
        <translation>グラフィックスドライバーが {name} を受け付けません：{log}</translation>
    </message>
    <message>
        <source>the key {name!r} is missing</source>
        <translation>キー {name!r} がありません</translation>
    </message>
    <message>
        <source>the key {name!r} is not a property that a style can set</source>
        <translation>キー {name!r} はスタイルで設定できるプロパティではありません</translation>
    </message>
    <message>
        <source>the key {name} is not known</source>
        <translation>キー {name} は知られていません</translation>
    </message>
    <message>
        <source>the key {twice} stands twice in one object</source>
        <translation>1 つのオブジェクトにキー {twice} が 2 回あります</translation>
    </message>
    <message>
        <source>the lamp stands within the card: its depth map cannot hold what lies around it</source>
        <translation>ライトがカードの中にあります。深度マップには周りを収められません</translation>
    </message>
    <message>
        <source>the layer has no drawings</source>
        <translation>レイヤーにセルがありません</translation>
    </message>
    <message>
        <source>the layer {layer!r} cannot be named in a job: it has braces</source>
        <translation>レイヤー {layer!r} は名前に波かっこがあるため、ジョブで指定できません</translation>
    </message>
    <message>
        <source>the names of the groups around {name!r} are too long</source>
        <translation>{name!r} を含むグループの名前が長すぎます</translation>
    </message>
    <message>
        <source>the number {text} is out of range</source>
        <translation>数 {text} は範囲を超えています</translation>
    </message>
    <message>
        <source>the operation is not permitted</source>
        <translation>この操作は許可されていません</translation>
    </message>
    <message>
        <source>the place to stand on is behind the camera {camera!r} on frame {frame}</source>
        <translation>フレーム {frame} で、立つ場所がカメラ {camera!r} の後ろにあります</translation>
    </message>
    <message>
        <source>the set is not before the camera on every frame</source>
        <translation>セットがカメラの前にないフレームがあります</translation>
    </message>
    <message>
        <source>the set pieces have {faces} flat faces: drawing a frame may take minutes; fewer steps or an imported set take less</source>
        <translation>セットに平面が {faces} 枚あり、1 フレームの描画に数分かかることがあります。段を減らすか、3Dセットを読み込むと速くなります</translation>
    </message>
    <message>
        <source>there are no triangles in it</source>
        <translation>三角形がひとつもありません</translation>
    </message>
    <message>
        <source>there are only triangles without an area in it</source>
        <translation>面積のない三角形しかありません</translation>
    </message>
    <message>
        <source>there is already a layer named {name!r}</source>
        <translation>{name!r} という名前のレイヤーはすでにあります</translation>
    </message>
    <message>
        <source>there is already a set piece named {name!r}</source>
        <translation>{name!r} という名前の大道具はすでにあります</translation>
    </message>
    <message>
        <source>there is an export preset {name!r} already</source>
        <translation>書き出しプリセット {name!r} はすでにあります</translation>
    </message>
    <message>
        <source>there is no OpenGL context to draw with</source>
        <translation>描画に使う OpenGL コンテキストがありません</translation>
    </message>
    <message>
        <source>there is no layer {address!r} in it</source>
        <translation>レイヤー {address!r} がありません</translation>
    </message>
    <message>
        <source>there is no layer {name!r} in this project, only {others}</source>
        <translation>このプロジェクトにレイヤー {name!r} はありません（あるのは {others} だけです）</translation>
    </message>
    <message>
        <source>there is no layer {name!r} in this project, only none at all</source>
        <translation>このプロジェクトにレイヤー {name!r} はありません（レイヤーがひとつもありません）</translation>
    </message>
    <message>
        <source>, joins {figure}</source>
        <translation>（{figure} の一部）</translation>
    </message>
    <message>
        <source>0 keeps the figure&apos;s own colours, 1 has the colour of the reflection alone.</source>
        <translation>0 で元の色のまま、1 で映り込みの色だけになります。</translation>
    </message>
    <message>
        <source>0 stands parallel to the screen, 1 along the ground&apos;s normal, as walls do.</source>
        <translation>0 は画面に平行に立ち、1 は壁のように地面の法線に沿って立ちます。</translation>
    </message>
    <message>
        <source>1 drawing</source>
        <translation>セル 1 枚</translation>
    </message>
    <message>
        <source>1 keyed property got a key on frame {frame}: {names}</source>
        <translation>キーのあるプロパティ 1 個の {frame} フレームにキーを打ちました：{names}</translation>
    </message>
    <message>
        <source>1 mirrors the figure as a body that stands up from the ground, 0 as the card that casts its shadow.</source>
        <translation>1 で地面に立つ体として映し、0 で影を落とす板として映します。</translation>
    </message>
    <message>
        <source>AWS Deadline Cloud: deadline bundle submit {folder}</source>
        <translation>AWS Deadline Cloud：deadline bundle submit {folder}</translation>
    </message>
    <message>
        <source>After Effects and Blender import it by RxLab&apos;s add-ons; holds, opacity and blend modes are in it.</source>
        <translation>After Effects と Blender は RxLab のアドオンで読み込みます。コマ数、不透明度、描画モードが入っています。</translation>
    </message>
    <message>
        <source>After Effects</source>
        <translation>After Effects</translation>
    </message>
    <message>
        <source>After the next export run it again: it brings the composition up to date and keeps your changes.</source>
        <translation>書き出し直したらもう一度実行します。変更した内容を残したまま、コンポジションが更新されます。</translation>
    </message>
    <message>
        <source>Alt or A: the other point goes the other way</source>
        <translation>Alt / A：もう一方は反対に動く</translation>
    </message>
    <message>
        <source>At this distance from the feet the reflection has faded away; 0 does not fade.</source>
        <translation>足元からこの距離で映り込みが消えます。0 で消えません。</translation>
    </message>
    <message>
        <source>Background position</source>
        <translation>背景の位置</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>Cast</source>
        <translation>投影</translation>
    </message>
    <message>
        <source>Casts</source>
        <translation>影を落とす</translation>
    </message>
    <message>
        <source>Colour that the reflection takes on, sRGB.</source>
        <translation>映り込みに付ける色 (sRGB)。</translation>
    </message>
    <message>
        <source>Contact size</source>
        <translation>接地影の大きさ</translation>
    </message>
    <message>
        <source>Contact softness</source>
        <translation>接地影のぼかし</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接地影</translation>
    </message>
    <message>
        <source>Ctrl: no snapping</source>
        <translation>Ctrl：吸着なし</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>円</translation>
    </message>
    <message>
        <source>Each file is one frame with a part for each layer, linear and with premultiplied alpha.</source>
        <translation>1 ファイルが 1 フレームで、レイヤーごとにパートがあります。リニアで、アルファは乗算済みです。</translation>
    </message>
    <message>
        <source>Each file is one frame; Photoshop and Clip Studio Paint open it with its layers.</source>
        <translation>1 ファイルが 1 フレームです。Photoshop や Clip Studio Paint でレイヤーごと開けます。</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>縁</translation>
    </message>
    <message>
        <source>Every file that is there is whole and stays.</source>
        <translation>書き出し済みのファイルはどれも完全で、そのまま残ります。</translation>
    </message>
    <message>
        <source>Export again with “Leave frames alone that would come out the same” ticked: it goes on where it was.</source>
        <translation>「変わらないフレームは書き出さない」にチェックを入れてもう一度書き出すと、続きから進みます。</translation>
    </message>
    <message>
        <source>Fade in a jump</source>
        <translation>跳躍時の薄れ</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>足</translation>
    </message>
    <message>
        <source>Foot, lifted</source>
        <translation>足（浮いている）</translation>
    </message>
    <message>
        <source>Foot, planted</source>
        <translation>足（接地）</translation>
    </message>
    <message>
        <source>Frames a second: 24, 23.976, 24000/1001; keys and drawings stay on their frames.</source>
        <translation>フレームレート：24、23.976、24000/1001。キーとセルのフレーム位置は変わりません。</translation>
    </message>
    <message>
        <source>From one row of gaps to the next on the ground; 0 is the length of wave 1.</source>
        <translation>地面上での切れ目の列の間隔。0では波1の波長になります。</translation>
    </message>
    <message>
        <source>Fusion</source>
        <translation>Fusion</translation>
    </message>
    <message>
        <source>Ground below the foot</source>
        <translation>足の下の地面</translation>
    </message>
    <message>
        <source>Ground line</source>
        <translation>接地ライン</translation>
    </message>
    <message>
        <source>H.264 has no alpha; for compositing, export shadow layers or a MOV.</source>
        <translation>H.264 にはアルファがありません。合成には影レイヤーか MOV を書き出します。</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>くっきり</translation>
    </message>
    <message>
        <source>Hold at the feet</source>
        <translation>足元に留める</translation>
    </message>
    <message>
        <source>How far a simplified shadow that has drawn away from the feet is slid back until it begins under them.</source>
        <translation>単純化で足元から離れた影を、足の下から始まる位置までどれだけ引き戻すか。</translation>
    </message>
    <message>
        <source>How large the drawings are; below 0 they are mirrored.</source>
        <translation>セルの大きさ。0 より小さいと反転します。</translation>
    </message>
    <message>
        <source>How many frames the cut has; what lies behind its end is kept.</source>
        <translation>カットのフレーム数。終わりより後ろにあるものも残ります。</translation>
    </message>
    <message>
        <source>How much of its opacity the shadow loses at a height of one figure over the ground.</source>
        <translation>地面からキャラクター 1 体分の高さで影の不透明度がどれだけ下がるか。</translation>
    </message>
    <message>
        <source>How much of its size the shadow loses at a height of one figure over the ground.</source>
        <translation>地面からキャラクター 1 体分の高さで影がどれだけ小さくなるか。</translation>
    </message>
    <message>
        <source>How much of the amplitude moves the shadow sideways: long streaks over 1, none at 0.</source>
        <translation>振幅のうち影を横に動かす割合。1を超えると長い筋になり、0では動きません。</translation>
    </message>
    <message>
        <source>How much of the amplitude moves the shadow toward the viewer and back; small is calm water.</source>
        <translation>振幅のうち影を手前と奥に動かす割合。小さいと静かな水面になります。</translation>
    </message>
    <message>
        <source>How much of the length of a crest of wave 1 is open, in long gaps without shadow; 0 has none.</source>
        <translation>波1の山に沿って、影のない細長い切れ目が占める長さの割合。0では切れ目がありません。</translation>
    </message>
    <message>
        <source>How much of the movement in depth is a movement sideways as well: streaks lean.</source>
        <translation>奥行きの動きにともなう横の動きの割合。筋が傾きます。</translation>
    </message>
    <message>
        <source>How much of the movement sideways is a movement in depth as well: streaks rise to one side.</source>
        <translation>横の動きにともなう奥行きの動きの割合。筋が片側へ上がります。</translation>
    </message>
    <message>
        <source>How much wider the gaps get with every px of distance from the feet.</source>
        <translation>足元から1px離れるごとに切れ目が広がる量。</translation>
    </message>
    <message>
        <source>How soft the edge of each patch is; 0 is crisp, 1 fades from its middle.</source>
        <translation>縁のぼかし。0 でくっきり、1 で中心からぼけます。</translation>
    </message>
    <message>
        <source>How wide each patch is; 1 is a tenth of the figure&apos;s height, about a shoe.</source>
        <translation>影の幅。1 は身長の 10 分の 1、靴くらいです。</translation>
    </message>
    <message>
        <source>Import each folder as one sequence of {rate} frames a second, with straight (unmatted) alpha.</source>
        <translation>フォルダーごとに 1 本の連番（{rate} fps）として読み込み、アルファは「ストレート - マットなし」にします。</translation>
    </message>
    <message>
        <source>Import each folder as one sequence of {rate} frames a second; EXR is linear, its alpha premultiplied.</source>
        <translation>フォルダーごとに 1 本の連番（{rate} fps）として読み込みます。EXR はリニアで、アルファは乗算済み（合成チャンネル）です。</translation>
    </message>
    <message>
        <source>Import it as footage of {rate} frames a second, with straight (unmatted) alpha.</source>
        <translation>{rate} fps のフッテージとして読み込み、アルファは「ストレート - マットなし」にします。</translation>
    </message>
    <message>
        <source>In After Effects: File &gt; Import &gt; File…, choose the first picture of a folder and tick “{format} Sequence”.</source>
        <translation>After Effects では［ファイル］＞［読み込み］＞［ファイル…］でフォルダーの先頭の画像を選び、「{format} シーケンス」にチェックを入れます。</translation>
    </message>
    <message>
        <source>In After Effects: File &gt; Import &gt; File…; one file as “Composition” has the layers, a “Photoshop Sequence” is the finished picture.</source>
        <translation>After Effects では［ファイル］＞［読み込み］＞［ファイル…］。1 ファイルを「コンポジション」で読み込むとレイヤーが、「Photoshop シーケンス」にすると完成した絵が入ります。</translation>
    </message>
    <message>
        <source>In After Effects: File &gt; Scripts &gt; Run Script File…, and choose {script}.</source>
        <translation>After Effects で［ファイル］＞［スクリプト］＞［スクリプトファイルを実行…］を選び、{script} を開きます。</translation>
    </message>
    <message>
        <source>In Blender 3.4 or newer: Scripting &gt; Open {file}, then Run Script.</source>
        <translation>Blender 3.4 以降：「Scripting」で {file} を開き、「スクリプト実行」を押します。</translation>
    </message>
    <message>
        <source>In Nuke: File &gt; Open Comp…, and choose {file}.</source>
        <translation>Nuke：File &gt; Open Comp… で {file} を選びます。</translation>
    </message>
    <message>
        <source>It builds a scene of its own: cards, camera, frame rate, and View Transform Raw, which must stay.</source>
        <translation>カード、カメラ、フレームレート、ビュー変換 Raw を持つ新しいシーンができます。Raw は変えないでください。</translation>
    </message>
    <message>
        <source>It builds the composition: frame rate, alpha, order, Multiply and opacity are set.</source>
        <translation>コンポジションが組み上がります。フレームレート、アルファ、重ね順、乗算、不透明度は設定済みです。</translation>
    </message>
    <message>
        <source>It is there as a whole or not at all: export again to make it.</source>
        <translation>途中までのファイルは残りません。もう一度書き出すと作られます。</translation>
    </message>
    <message>
        <source>It plays in any player and browser: look at it, or send it round.</source>
        <translation>どのプレーヤーやブラウザーでも再生できます。確認や回覧に使います。</translation>
    </message>
    <message>
        <source>Lay each shadow under its character and set it to Multiply.</source>
        <translation>影をそれぞれのキャラクターの下に置き、描画モードを「乗算」にします。</translation>
    </message>
    <message>
        <source>Lay each shadow under its character, in the blend mode that it has here.</source>
        <translation>影をそれぞれのキャラクターの下に置き、描画モードをここと同じにします。</translation>
    </message>
    <message>
        <source>Layered frames</source>
        <translation>レイヤー付きフレーム</translation>
    </message>
    <message>
        <source>Layers are merged as they are stored; the last nodes turn the sum to linear light.</source>
        <translation>レイヤーは保存された値のまま重ねられ、最後のノードで結果がリニアに変換されます。</translation>
    </message>
    <message>
        <source>Least part</source>
        <translation>最小の部分</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>除く</translation>
    </message>
    <message>
        <source>Light step</source>
        <translation>ライトの刻み</translation>
    </message>
    <message>
        <source>Loaders read the pictures as they are stored: set no colour space for them.</source>
        <translation>Loader は画像を保存された値のまま読みます。カラースペースは設定しないでください。</translation>
    </message>
    <message>
        <source>Natron 2 builds the project when it is started with the script: Natron {file}</source>
        <translation>Natron 2 をスクリプト付きで起動するとプロジェクトができます：Natron {file}</translation>
    </message>
    <message>
        <source>Natron</source>
        <translation>Natron</translation>
    </message>
    <message>
        <source>Nuke</source>
        <translation>Nuke</translation>
    </message>
    <message>
        <source>Nuke, Natron and Blender read the parts as layers.</source>
        <translation>Nuke、Natron、Blender はパートをレイヤーとして読み込みます。</translation>
    </message>
    <message>
        <source>Opacity and blend mode of every layer are kept: nothing has to be set.</source>
        <translation>不透明度と描画モードはそのまま入っているので、設定は要りません。</translation>
    </message>
    <message>
        <source>Opacity of a small dark patch under each foot on the ground, in the colour of the shadow; 0 is none.</source>
        <translation>地面についた足の下の小さな濃い影の不透明度。影の色で描きます。0 でなし。</translation>
    </message>
    <message>
        <source>Opacity of the figure mirrored in the ground, moved by the waves of its shadow; 0 is none.</source>
        <translation>地面に映るキャラクターの不透明度。影と同じ波で揺れます。0 でなし。</translation>
    </message>
    <message>
        <source>Open Cel Animation</source>
        <translation>Open Cel Animation（OCA）</translation>
    </message>
    <message>
        <source>Other farms: openjd run {template} --step Render</source>
        <translation>そのほかのファーム：openjd run {template} --step Render</translation>
    </message>
    <message>
        <source>Overhead radius; the lamp is {away} px outside it</source>
        <translation>真上ライトの範囲（ライトは {away} px 外側にあります）</translation>
    </message>
    <message>
        <source>Overhead simplify</source>
        <translation>真上ライトの単純化</translation>
    </message>
    <message>
        <source>Painted shadow</source>
        <translation>描き込みの影</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Reflection colour</source>
        <translation>映り込みの色</translation>
    </message>
    <message>
        <source>Reflection fade</source>
        <translation>映り込みの減衰</translation>
    </message>
    <message>
        <source>Reflection tone</source>
        <translation>映り込みの色味</translation>
    </message>
    <message>
        <source>Reflection upright</source>
        <translation>映り込みの直立</translation>
    </message>
    <message>
        <source>Reflection</source>
        <translation>映り込み</translation>
    </message>
    <message>
        <source>Render farm job</source>
        <translation>レンダーファームのジョブ</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Scale of the cel</source>
        <translation>セルのスケール</translation>
    </message>
    <message>
        <source>Shadow layers</source>
        <translation>影レイヤー</translation>
    </message>
    <message>
        <source>Shadows unite</source>
        <translation>影を合わせる</translation>
    </message>
    <message>
        <source>Shift+Alt or Shift+A: slowly</source>
        <translation>Shift+Alt / Shift+A：ゆっくり</translation>
    </message>
    <message>
        <source>Shift: keeps its shape</source>
        <translation>Shift：比率を保つ</translation>
    </message>
    <message>
        <source>Shift: one way</source>
        <translation>Shift：一方向</translation>
    </message>
    <message>
        <source>Shift: steps of 15°</source>
        <translation>Shift：15° 刻み</translation>
    </message>
    <message>
        <source>Shrink in a jump</source>
        <translation>跳躍時の縮み</translation>
    </message>
    <message>
        <source>Slit growth</source>
        <translation>切れ目の広がり</translation>
    </message>
    <message>
        <source>Slit spacing</source>
        <translation>切れ目の間隔</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>切れ目</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>滑らか</translation>
    </message>
    <message>
        <source>Smooth: anti-aliased; hard: a pixel is all shadow or none, as in pixel art, whatever the softness.</source>
        <translation>滑らか：アンチエイリアスあり。くっきり：ドット絵のように、ぼかしに関係なく 1 ピクセルは影か影でないかのどちらか。</translation>
    </message>
    <message>
        <source>So much at least shadows are simplified while the lamp is straight above, which joins its four to one.</source>
        <translation>ライトが真上にある間、影は少なくともこの量だけ単純化され、四つの影が一つにまとまります。</translation>
    </message>
    <message>
        <source>Soften in a jump</source>
        <translation>跳躍時のぼけ</translation>
    </message>
    <message>
        <source>Stance</source>
        <translation>立ち方</translation>
    </message>
    <message>
        <source>The colour of the layer&apos;s label in the window.</source>
        <translation>画面でのレイヤーのラベルの色。</translation>
    </message>
    <message>
        <source>The lamp moves by whole steps of this length, so that pixel art does not shimmer; 0 moves freely.</source>
        <translation>ライトがこの長さの刻みで動き、ドット絵の影がちらつきません。0 で自由に動きます。</translation>
    </message>
    <message>
        <source>The layer whose figure this one is a part of; empty for a figure of its own.</source>
        <translation>このレイヤーが属するキャラクターのレイヤー。空なら独立したキャラクターになります。</translation>
    </message>
    <message>
        <source>The name of the production or the episode.</source>
        <translation>作品または話数の名前。</translation>
    </message>
    <message>
        <source>The number of the cut, which may have letters; a timesheet that is written bears it.</source>
        <translation>カット番号（文字も使えます）。書き出すタイムシートに記されます。</translation>
    </message>
    <message>
        <source>The number of the scene, which may have letters.</source>
        <translation>シーン番号（文字も使えます）。</translation>
    </message>
    <message>
        <source>The point of the drawing that is laid on the position; drawings turn and grow about it.</source>
        <translation>位置に置かれるセル上の点。セルはこの点を中心に回転・拡大します。</translation>
    </message>
    <message>
        <source>The scene finds its pictures beside itself: move the folder as a whole.</source>
        <translation>シーンは同じフォルダーの画像を使います。移動するときはフォルダーごと移してください。</translation>
    </message>
    <message>
        <source>The script is written last, when all it needs is there.</source>
        <translation>スクリプトは、必要なものがそろった最後に書き出されます。</translation>
    </message>
    <message>
        <source>The shadow that the light casts, or a disc under the figure.</source>
        <translation>光が落とす影、またはキャラクターの足元の円。</translation>
    </message>
    <message>
        <source>Turn of the cel</source>
        <translation>セルの回転</translation>
    </message>
    <message>
        <source>Turn of the drawings in the picture, clockwise.</source>
        <translation>画面内でのセルの回転（時計回り）。</translation>
    </message>
    <message>
        <source>USD files need the package usd-core: {how}</source>
        <translation>USD ファイルにはパッケージ usd-core が要ります：{how}</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>直立</translation>
    </message>
    <message>
        <source>Video</source>
        <translation>動画</translation>
    </message>
    <message>
        <source>Wave {number} depth shear</source>
        <translation>波{number} 奥行きへの傾き</translation>
    </message>
    <message>
        <source>Wave {number} in depth</source>
        <translation>波{number} 奥行きの動き</translation>
    </message>
    <message>
        <source>Wave {number} sideways shear</source>
        <translation>波{number} 横への傾き</translation>
    </message>
    <message>
        <source>Wave {number} sideways</source>
        <translation>波{number} 横の動き</translation>
    </message>
    <message>
        <source>What the figure stands on: its feet where they were found, its grounding points, or the ground line.</source>
        <translation>キャラクターが何で立つか：見つかった足、接地点、または接地ライン。</translation>
    </message>
    <message>
        <source>Where drawings have no alpha, white is clear everywhere, or only where it reaches the border.</source>
        <translation>アルファのないセルで白を透明にする範囲。すべての白（white）か、縁につながる白だけ（border）か。</translation>
    </message>
    <message>
        <source>Where the anchor of the layer&apos;s drawings lies on the canvas.</source>
        <translation>レイヤーのセルの基準点がキャンバスのどこに置かれるか。</translation>
    </message>
    <message>
        <source>Where the middle of the background lies on the canvas: keyed, it pans.</source>
        <translation>背景の中心がキャンバスのどこに置かれるか。キーを打つとパンします。</translation>
    </message>
    <message>
        <source>Whether a shadow that is painted into the drawings, half-transparent at the base, casts with them.</source>
        <translation>セルの足元に半透明で描き込まれた影も、セルと一緒に影を落とすかどうか。</translation>
    </message>
    <message>
        <source>Whether shadows of like look unite where they meet; else each darkens what the others left.</source>
        <translation>同じ見た目の影が重なる所で一つになるか。オフでは重なるほど濃くなります。</translation>
    </message>
    <message>
        <source>Whether the window refuses to change the layer; the command line changes it all the same.</source>
        <translation>画面でレイヤーの変更を受け付けないかどうか。コマンドラインでは変更できます。</translation>
    </message>
    <message>
        <source>Whether the window shows the layer alone; exports show all.</source>
        <translation>画面でこのレイヤーだけを表示するかどうか。書き出しにはすべて含まれます。</translation>
    </message>
    <message>
        <source>Width and height of the picture in px; --drawings says what becomes of what is on it.</source>
        <translation>画面の幅と高さ（px）。画面上のものをどう扱うかは --drawings で指定します。</translation>
    </message>
    <message>
        <source>a canvas of {width} × {height} px needs about {needed} MB of memory to be drawn, of which {free} MB are free</source>
        <translation>{width} × {height} px のキャンバスを描くには約 {needed} MB のメモリーが必要ですが、空きは {free} MB です</translation>
    </message>
    <message>
        <source>a column of dialogue or camera work cannot be read</source>
        <translation>セリフまたはカメラワークの列が読めません</translation>
    </message>
    <message>
        <source>a composition of Loaders and Merges</source>
        <translation>Loader と Merge のコンポジション</translation>
    </message>
    <message>
        <source>a dash before a number is taken as a minus: {first}</source>
        <translation>番号の前のハイフンをマイナスとみなしました：{first}</translation>
    </message>
    <message>
        <source>a file to look at, or one with alpha</source>
        <translation>確認用の動画、またはアルファ付きの動画</translation>
    </message>
    <message>
        <source>a layered frame holds the shadows of a look as a group; ask for one of the two</source>
        <translation>レイヤー付きフレームには同じ見た目の影がグループとして入っています。どちらか一方を選んでください</translation>
    </message>
    <message>
        <source>a point [{axes}] in {unit}</source>
        <translation>点 [{axes}] ({unit})</translation>
    </message>
    <message>
        <source>a project holds at most {megabytes} MB and {most} values</source>
        <translation>1 つのプロジェクトに入るのは {megabytes} MB、値 {most} 個までです</translation>
    </message>
    <message>
        <source>a scene has at most {most} px a side, the canvas has more</source>
        <translation>シーンの一辺は最大 {most} px ですが、キャンバスはそれより大きいです</translation>
    </message>
    <message>
        <source>a script of Read and Merge nodes</source>
        <translation>Read ノードと Merge ノードのスクリプト</translation>
    </message>
    <message>
        <source>a script that builds readers and merges</source>
        <translation>Read と Merge を組むスクリプト</translation>
    </message>
    <message>
        <source>a script that builds the whole composition</source>
        <translation>コンポジションを組み立てるスクリプト</translation>
    </message>
    <message>
        <source>an answer needs words, and a note has at most {most} answers</source>
        <translation>返信には本文が要ります。1 つのメモに付けられる返信は {most} 件までです</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>返信</translation>
    </message>
    <message>
        <source>at {rate} frames a second the cut lasts {after} instead of {before} s; keys and drawings stay on their frames</source>
        <translation>{rate} fps では尺が {before} 秒から {after} 秒になります。キーとセルのフレーム位置は変わりません</translation>
    </message>
    <message>
        <source>author</source>
        <translation>書いた人</translation>
    </message>
    <message>
        <source>background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>background: {names}</source>
        <translation>背景：{names}</translation>
    </message>
    <message>
        <source>blending by brightness is not done: {names}</source>
        <translation>「ブレンド条件」（明るさによる合成）は行いません：{names}</translation>
    </message>
    <message>
        <source>camera {name}: {kind}, {moving}</source>
        <translation>カメラ {name}：{kind}、{moving}</translation>
    </message>
    <message>
        <source>canvas: a first frame of {first} is not within 0 to {most}</source>
        <translation>canvas：開始フレーム {first} は 0～{most} の範囲にありません</translation>
    </message>
    <message>
        <source>cards before a camera, shadows among them</source>
        <translation>カメラの前に並べたカードと影</translation>
    </message>
    <message>
        <source>character {name}{joins}: {drawings} of {width} × {height} px, seen to frame {last}: {names}</source>
        <translation>キャラクター {name}{joins}：{width} × {height} px の{drawings}、{last} コマ目まで表示：{names}</translation>
    </message>
    <message>
        <source>column {name!r}: {count} entries of {cels} cels: {names}</source>
        <translation>列 {name!r}：記入 {count} 個、セル {cels} 枚：{names}</translation>
    </message>
    <message>
        <source>composites</source>
        <translation>合成画像</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>接地影</translation>
    </message>
    <message>
        <source>copies of the background</source>
        <translation>背景のコピー</translation>
    </message>
    <message>
        <source>copies of the drawings</source>
        <translation>セルのコピー</translation>
    </message>
    <message>
        <source>done</source>
        <translation>済み</translation>
    </message>
    <message>
        <source>drawing gradients, strokes and curves of Photoshop layers</source>
        <translation>Photoshop レイヤーのグラデーション・境界線・トーンカーブの描画</translation>
    </message>
    <message>
        <source>drawings and all lengths become {percent:.4g} % of what they were</source>
        <translation>セルとすべての長さが元の {percent:.4g} % になります</translation>
    </message>
    <message>
        <source>drawings exposed behind the new end, kept and not seen: {count}</source>
        <translation>新しい終わりより後ろのセル（残りますが表示されません）：{count} 枚</translation>
    </message>
    <message>
        <source>drawings of {column}: {path}</source>
        <translation>{column} のセル：{path}</translation>
    </message>
    <message>
        <source>drawings that have another size than before: {names}</source>
        <translation>以前とサイズの違うセル：{names}</translation>
    </message>
    <message>
        <source>extra channels are not used: {names}</source>
        <translation>追加のチャンネルは使いません：{names}</translation>
    </message>
    <message>
        <source>files of the job</source>
        <translation>ジョブのファイル</translation>
    </message>
    <message>
        <source>folders beside its pictures are left out: {names}</source>
        <translation>画像と同じ場所にあるフォルダーは使いません：{names}</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>frames are counted from 0 in OCA: its frame 0 is frame {first} here</source>
        <translation>OCA ではフレームを 0 から数えます。OCA のフレーム 0 はここではフレーム {first} です</translation>
    </message>
    <message>
        <source>frames made by other machines</source>
        <translation>ほかのマシンでフレームを書き出すジョブ</translation>
    </message>
    <message>
        <source>frames of sets as clay</source>
        <translation>クレイ表示のセットのフレーム</translation>
    </message>
    <message>
        <source>groups are clipped to the layer below them, as Clip Studio Paint does: {names}</source>
        <translation>フォルダーを下のレイヤーでクリッピングします（CLIP STUDIO PAINT と同じ扱い）：{names}</translation>
    </message>
    <message>
        <source>guides are drawn into composites; ask for those as well</source>
        <translation>ガイドは合成画像に描かれます。合成画像も指定してください</translation>
    </message>
    <message>
        <source>it belongs to somebody else</source>
        <translation>ほかのユーザーのものです</translation>
    </message>
    <message>
        <source>it cannot be read as USD: the file is damaged, or too large for the memory</source>
        <translation>USD として読めません：ファイルが壊れているか、メモリーに対して大きすぎます</translation>
    </message>
    <message>
        <source>it cannot go past the key that stays</source>
        <translation>止まっているキーは越えられません</translation>
    </message>
    <message>
        <source>it does not say which axis points up: y is taken</source>
        <translation>どの軸が上を向くかの指定がないため、y 軸を上とみなします</translation>
    </message>
    <message>
        <source>it ends within a solid: something may be missing</source>
        <translation>ソリッドの途中で終わっています。欠けている部分があるかもしれません</translation>
    </message>
    <message>
        <source>it has light where its alpha is 0, as a glow has; that is not used</source>
        <translation>アルファが 0 の所に発光のような光がありますが、使いません</translation>
    </message>
    <message>
        <source>it has light where its alpha is 0; that is seen as a glow over what is behind it</source>
        <translation>アルファが 0 の所に光があります。後ろのものに重なる発光として表示します</translation>
    </message>
    <message>
        <source>it has more than {most} prims</source>
        <translation>プリムが {most} 個を超えています</translation>
    </message>
    <message>
        <source>it has more than {most} values</source>
        <translation>値が {most} 個を超えています</translation>
    </message>
    <message>
        <source>it has no scene: all of its nodes are read</source>
        <translation>シーンがないため、すべてのノードを読みます</translation>
    </message>
    <message>
        <source>layers and holds for many programs</source>
        <translation>多くのソフトで読めるレイヤーとコマ</translation>
    </message>
    <message>
        <source>no drawing is missing</source>
        <translation>見つからないセルはありません</translation>
    </message>
    <message>
        <source>nothing fills the canvas; Blender has white there</source>
        <translation>キャンバスを埋めるものがありません。Blender ではそこが白になります</translation>
    </message>
    <message>
        <source>nothing fills the canvas; Fusion has white there</source>
        <translation>キャンバスを埋めるものがありません。Fusion ではそこが白になります</translation>
    </message>
    <message>
        <source>pictures of layers</source>
        <translation>レイヤーの画像</translation>
    </message>
    <message>
        <source>pip install {packages}</source>
        <translation>pip install {packages} を実行</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>シーン</translation>
    </message>
    <message>
        <source>the layer {name!r} lies in the folder {folder!r}</source>
        <translation>レイヤー{name!r} はフォルダー{folder!r} にあります</translation>
    </message>
    <message>
        <source>the shadows of {layers} are handed over as one, with their opacity in it, for no layers make the picture: they unite on some frames only, have a second colour, or change places with others</source>
        <translation>{layers} の影は、レイヤーの重ね合わせでは同じ絵にならないため、不透明度を含めて一枚にまとめて渡します（一部のフレームでだけ一体になる、第二の色がある、または他の影と順序が入れ替わるため）</translation>
    </message>
    <message>
        <source>video needs PyAV, which is not installed: {how}</source>
        <translation>動画には PyAV が要りますが、入っていません：{how}</translation>
    </message>
    <message>
        <source>{name}: contacts that moved by more than 1 % of the height: frames {frames}</source>
        <translation>{name}：接地が身長の 1 % より大きく動いたフレーム：{frames}</translation>
    </message>
    <message>
        <source>{name}: drawings that are gone: {names}</source>
        <translation>{name}：なくなったセル：{names}</translation>
    </message>
    <message>
        <source>{name}: keys that came upon another key and are left out: {keys}</source>
        <translation>{name}：ほかのキーと重なるため除いたキー：{keys}</translation>
    </message>
    <message>
        <source>{name}: known again under another name: {picture} by the same picture, {likeness} by likeness, {order} by their order</source>
        <translation>{name}：名前の変わったセル：同じ画像 {picture} 枚、似た画像 {likeness} 枚、並び順 {order} 枚</translation>
    </message>
    <message>
        <source>{name}: new drawings: {names}</source>
        <translation>{name}：新しいセル：{names}</translation>
    </message>
    <message>
        <source>{name}: no timing shows these: {names}</source>
        <translation>{name}：どのコマにも出ないセル：{names}</translation>
    </message>
    <message>
        <source>{name}: please look at frames {frames}</source>
        <translation>{name}：確認してほしいフレーム：{frames}</translation>
    </message>
    <message>
        <source>{name}: these are not drawn without a part that is missing ({how}): {by_extra}</source>
        <translation>{name}：足りない部品があるため描画されないもの（{how}）：{by_extra}</translation>
    </message>
    <message>
        <source>{name}: where a drawing is gone the one before is held (frames {frames})</source>
        <translation>{name}：なくなったセルのコマは、前のセルを止めて使います（フレーム {frames}）</translation>
    </message>
    <message>
        <source>it is damaged: an instancer names what is not there</source>
        <translation>壊れています：インスタンサーが存在しないものを参照しています</translation>
    </message>
    <message>
        <source>; kagezou style lists them</source>
        <translation>。一覧は kagezou style です</translation>
    </message>
    <message>
        <source>A column for each layer; effects in the schematic have its blend mode and its opacity.</source>
        <translation>レイヤーごとに列ができます。描画モードと不透明度はスケマティックのエフェクトにあります。</translation>
    </message>
    <message>
        <source>All cuts</source>
        <translation>すべてのカット</translation>
    </message>
    <message>
        <source>Cuts of {name}</source>
        <translation>{name} のカット</translation>
    </message>
    <message>
        <source>Doubtful</source>
        <comment>cuts that are shown</comment>
        <translation>要確認</translation>
    </message>
    <message>
        <source>Failed</source>
        <comment>cuts that are shown</comment>
        <translation>失敗</translation>
    </message>
    <message>
        <source>In Fusion: File &gt; Open…, and choose {file}; DaVinci Resolve imports it as a Fusion composition.</source>
        <translation>Fusion：File &gt; Open… で {file} を選びます。DaVinci Resolve では Fusion コンポジションとして読み込みます。</translation>
    </message>
    <message>
        <source>In OpenToonz: File &gt; Load Scene…, and choose {file}.</source>
        <translation>OpenToonz：File &gt; Load Scene… で {file} を選びます。</translation>
    </message>
    <message>
        <source>Kagezou, {time}</source>
        <translation>Kagezou&#x3000;{time}</translation>
    </message>
    <message>
        <source>Kagezou, {time}; still being made, this page renews itself</source>
        <translation>Kagezou&#x3000;{time}（処理中です。このページは自動で更新されます）</translation>
    </message>
    <message>
        <source>Lamp</source>
        <comment>a kind of light</comment>
        <translation>ランプ</translation>
    </message>
    <message>
        <source>OpenToonz imports {file} by File &gt; Import &gt; Open Cel Animation (OCA), without blend modes.</source>
        <translation>OpenToonz は File &gt; Import &gt; Open Cel Animation (OCA) で {file} を読み込みます。描画モードは読まれません。</translation>
    </message>
    <message>
        <source>OpenToonz</source>
        <translation>OpenToonz</translation>
    </message>
    <message>
        <source>Order</source>
        <comment>of cuts</comment>
        <translation>並び順</translation>
    </message>
    <message>
        <source>Output</source>
        <comment>a link</comment>
        <translation>出力</translation>
    </message>
    <message>
        <source>Project</source>
        <comment>a link</comment>
        <translation>プロジェクト</translation>
    </message>
    <message>
        <source>The blend mode of each is its attribute kagezou:blend; laid in sRGB, not in linear light, they make the picture.</source>
        <translation>各パートの合成モードは属性 kagezou:blend にあります。リニアではなく sRGB で重ねると、元の画になります。</translation>
    </message>
    <message>
        <source>The farm calls {program} and renders the saved project into {output}: save before you send the job.</source>
        <translation>ファームは {program} を起動し、保存済みのプロジェクトを {output} にレンダリングします。ジョブを送る前に保存してください。</translation>
    </message>
    <message>
        <source>The number that the first frame bears in the window and in files; --frame and --frames count from 1.</source>
        <translation>ウィンドウとファイルで先頭フレームに付く番号です。--frame と --frames は常に 1 から数えます。</translation>
    </message>
    <message>
        <source>There are no cuts.</source>
        <translation>カットがありません。</translation>
    </message>
    <message>
        <source>With remarks</source>
        <comment>cuts that are shown</comment>
        <translation>メモあり</translation>
    </message>
    <message>
        <source>a frame may take 1 to {most_minutes} minutes, not {minutes}</source>
        <translation>1 フレームにかけられる時間は 1〜{most_minutes} 分です（指定: {minutes}）</translation>
    </message>
    <message>
        <source>a job has at most {most} cuts, not {cuts}; make several</source>
        <translation>ひとつのジョブは {most} カットまでです（{cuts} カットあります）。いくつかに分けてください</translation>
    </message>
    <message>
        <source>a number has 1 to {most} digits, not {digits}</source>
        <translation>番号の桁数は 1 から {most} までです（{digits} は使えません）</translation>
    </message>
    <message>
        <source>a process that shared the work ended by itself; {count} pictures were made again</source>
        <translation>作業を分担していたプロセスが途中で終了しました。{count} 枚の画像を作り直しました</translation>
    </message>
    <message>
        <source>a scene with a column for each layer</source>
        <translation>レイヤーごとに列を持つシーン</translation>
    </message>
    <message>
        <source>as they were given</source>
        <translation>指定した順</translation>
    </message>
    <message>
        <source>being made</source>
        <comment>a cut</comment>
        <translation>処理中</translation>
    </message>
    <message>
        <source>cuts</source>
        <translation>カット</translation>
    </message>
    <message>
        <source>failed ones first</source>
        <translation>失敗したものから</translation>
    </message>
    <message>
        <source>failed</source>
        <comment>a cut</comment>
        <translation>失敗</translation>
    </message>
    <message>
        <source>failed</source>
        <comment>cuts</comment>
        <translation>失敗</translation>
    </message>
    <message>
        <source>file names {pattern!r}: a brace has no partner</source>
        <translation>ファイル名 {pattern!r}：波かっこの対応が取れていません</translation>
    </message>
    <message>
        <source>file names {pattern!r}: the digits of a number are said twice</source>
        <translation>ファイル名 {pattern!r}：番号の桁数が二重に指定されています</translation>
    </message>
    <message>
        <source>file names {pattern!r}: the name of the file needs {{frame}} once</source>
        <translation>ファイル名 {pattern!r}：ファイル名の部分に {{frame}} が 1 回必要です</translation>
    </message>
    <message>
        <source>file names {pattern!r}: there is no word {word!r}, only {known}</source>
        <translation>ファイル名 {pattern!r}：{word!r} という語はありません。使えるのは {known} です</translation>
    </message>
    <message>
        <source>file names {pattern!r}: this is no place under the output folder</source>
        <translation>ファイル名 {pattern!r}：出力フォルダーの中の場所になりません</translation>
    </message>
    <message>
        <source>file names {pattern!r}: {one} and {other} would have the same files; {{layer}} and {{kind}} tell them apart</source>
        <translation>ファイル名 {pattern!r}：{one} と {other} が同じファイルになります。{{layer}} と {{kind}} で区別してください</translation>
    </message>
    <message>
        <source>files are numbered from 0 to {most}, not from {first}</source>
        <translation>ファイルの開始番号は 0 から {most} までです（{first} は使えません）</translation>
    </message>
    <message>
        <source>frame {frame}: doubtful</source>
        <translation>フレーム {frame}：要確認</translation>
    </message>
    <message>
        <source>frames are counted from 1 in OpenToonz: its frame 1 is frame {first} here</source>
        <translation>OpenToonz ではフレームを 1 から数えます。OpenToonz のフレーム 1 はここではフレーム {first} です</translation>
    </message>
    <message>
        <source>frames</source>
        <comment>of all cuts</comment>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>handed on to {hook}</source>
        <translation>{hook} に渡しました</translation>
    </message>
    <message>
        <source>handed on to {hook}: {said}</source>
        <translation>{hook} に渡しました：{said}</translation>
    </message>
    <message>
        <source>it does not say its {name}; {usual} was taken</source>
        <translation>{name} が書かれていないため、{usual} としました</translation>
    </message>
    <message>
        <source>it is damaged: instances are made of themselves</source>
        <translation>壊れています：インスタンスが自分自身を含んでいます</translation>
    </message>
    <message>
        <source>it is damaged: what is compressed in it cannot be read</source>
        <translation>壊れています：圧縮されたデータを読めません</translation>
    </message>
    <message>
        <source>it is larger than {megabytes} MB</source>
        <translation>{megabytes} MB を超えています</translation>
    </message>
    <message>
        <source>it is made of more than {most} layers</source>
        <translation>{most} 個を超えるレイヤーでできています</translation>
    </message>
    <message>
        <source>it is too large for values</source>
        <translation>値のファイルとしては大きすぎます</translation>
    </message>
    <message>
        <source>it is too large for what is not used of it to be kept for writing</source>
        <translation>大きすぎるため、使わない内容は書き出し用に保存されません</translation>
    </message>
    <message>
        <source>it refers to {names}, which cannot be read</source>
        <translation>参照している {names} を読めません</translation>
    </message>
    <message>
        <source>it requires glTF {version}; only glTF 2.0 is read</source>
        <translation>glTF {version} を必要としています。読めるのは glTF 2.0 だけです</translation>
    </message>
    <message>
        <source>it requires the extensions {names}, which are not read</source>
        <translation>拡張機能 {names} を必要としていますが、対応していません</translation>
    </message>
    <message>
        <source>it would come back as something else</source>
        <translation>別の内容として復元されてしまいます</translation>
    </message>
    <message>
        <source>its alpha is 0 everywhere; its colours are seen as if there were none</source>
        <translation>アルファが全面 0 のため、アルファのない画像として色を表示します</translation>
    </message>
    <message>
        <source>its animation of {count} frames is not used: layers count as they are visible now</source>
        <translation>{count} フレームのアニメーションは使いません。レイヤーは現在の表示状態のまま扱います</translation>
    </message>
    <message>
        <source>its background colour is not used</source>
        <translation>背景色は使われません</translation>
    </message>
    <message>
        <source>its cameras {names} are mirrored, which is not done</source>
        <translation>カメラ {names} は鏡像ですが、反転はしません</translation>
    </message>
    <message>
        <source>its cameras {names} hang on no node and are not used</source>
        <translation>カメラ {names} はどのノードにも付いていないため使いません</translation>
    </message>
    <message>
        <source>its colour profile is damaged and not used</source>
        <translation>カラープロファイルが壊れているため使われません</translation>
    </message>
    <message>
        <source>its colour profile is not used</source>
        <translation>カラープロファイルは使われません</translation>
    </message>
    <message>
        <source>its colour profile {profile!r} is not used: colours are taken as sRGB</source>
        <translation>カラープロファイル {profile!r} は使いません。色は sRGB とみなします</translation>
    </message>
    <message>
        <source>its colours are inks with further channels, which cannot be read</source>
        <translation>追加チャンネルのあるインク（CMYK など）の色は読めません</translation>
    </message>
    <message>
        <source>its colours are taken as linear light of Rec. 709, though it calls them {name}</source>
        <translation>色空間は {name} とありますが、Rec. 709 のリニアとして扱います</translation>
    </message>
    <message>
        <source>its colours are taken as sRGB, though it calls them {primaries}/{transfer}</source>
        <translation>色の指定は {primaries}/{transfer} ですが、sRGB として扱います</translation>
    </message>
    <message>
        <source>its columns of key drawings are not used</source>
        <translation>原画欄は使いません</translation>
    </message>
    <message>
        <source>its columns of the kind {kind} are not used</source>
        <translation>種類 {kind} の欄は使いません</translation>
    </message>
    <message>
        <source>its columns</source>
        <translation>すべての列</translation>
    </message>
    <message>
        <source>its curved surfaces are not used</source>
        <translation>曲面（サーフェス）は使いません</translation>
    </message>
    <message>
        <source>its curves are not used</source>
        <translation>カーブは使いません</translation>
    </message>
    <message>
        <source>its elements {names} are not used</source>
        <translation>要素 {names} は使いません</translation>
    </message>
    <message>
        <source>its files changed while it was made, so it is made again the next time</source>
        <translation>作っている間にファイルが変わったため、次回もう一度作ります</translation>
    </message>
    <message>
        <source>its fourth channel, of which it does not say what it is, was taken as alpha</source>
        <translation>用途の指定がない 4 番目のチャンネルをアルファとみなしました</translation>
    </message>
    <message>
        <source>its gain map for bright screens is not used: it is seen as on other screens</source>
        <translation>HDR 画面用のゲインマップは使わず、通常の画面での見え方で表示します</translation>
    </message>
    <message>
        <source>its inks (CMYK) have no colour profile: its colours are an approximation</source>
        <translation>CMYK ですがカラープロファイルがないため、色は近似です</translation>
    </message>
    <message>
        <source>its inks (CMYK) were turned into sRGB by its colour profile</source>
        <translation>CMYK をカラープロファイルにより sRGB に変換しました</translation>
    </message>
    <message>
        <source>its layer comps are not used: layers count as they are visible now</source>
        <translation>レイヤーカンプは使いません。レイヤーは現在の表示状態のまま扱います</translation>
    </message>
    <message>
        <source>its layers were not compared with the picture in it: it is too large or not in RGB</source>
        <translation>大きすぎるか RGB ではないため、レイヤーを保存済みの統合画像と比べていません</translation>
    </message>
    <message>
        <source>its layers, put together here, differ from the picture saved with them by up to {levels:.0f} of 255 levels; by more than {least} in {share:.1%} of the picture</source>
        <translation>ここで合成したレイヤーは、保存済みの統合画像と最大 {levels:.0f}/255 階調異なります（{least} 階調を超える差は画像の {share:.1%}）</translation>
    </message>
    <message>
        <source>its length is missing; it ends with its last entry</source>
        <translation>長さの記載がないため、最後の記入までとしました</translation>
    </message>
    <message>
        <source>its lines are not used</source>
        <translation>線は使いません</translation>
    </message>
    <message>
        <source>its meshes are animated: they are used as they stand without that</source>
        <translation>メッシュにアニメーションがありますが、動かない状態の形を使います</translation>
    </message>
    <message>
        <source>its morph targets are used with the weights that the file sets at first</source>
        <translation>モーフターゲットには、ファイルの初期ウェイトを使います</translation>
    </message>
    <message>
        <source>its path has {count} characters, and Windows takes {most} unless long paths are switched on</source>
        <translation>パスが {count} 文字あります。Windows で使えるのは {most} 文字までです（長いパスを有効にした場合を除く）</translation>
    </message>
    <message>
        <source>its process ended with exit code {code}: {said}</source>
        <translation>処理が終了コード {code} で終わりました：{said}</translation>
    </message>
    <message>
        <source>its process was ended by {signal}</source>
        <translation>処理が {signal} で強制終了しました</translation>
    </message>
    <message>
        <source>its project was changed by hand: it stays as it is, and the output is made of it</source>
        <translation>プロジェクトが手で変更されています。そのまま残し、出力はそこから作りました</translation>
    </message>
    <message>
        <source>its second channel, of which it does not say what it is, was taken as alpha</source>
        <translation>用途の指定がない 2 番目のチャンネルをアルファとみなしました</translation>
    </message>
    <message>
        <source>its shapes are animated: they are used as on its first frame</source>
        <translation>形状にアニメーションがありますが、最初のフレームの形を使います</translation>
    </message>
    <message>
        <source>its single points are not used</source>
        <translation>点は使いません</translation>
    </message>
    <message>
        <source>its skins are posed as on its first frame</source>
        <translation>スキンには、最初のフレームのポーズを使います</translation>
    </message>
    <message>
        <source>its skins are posed as their joints stand without animation</source>
        <translation>スキンには、アニメーションなしのジョイントのポーズを使います</translation>
    </message>
    <message>
        <source>its subdivision surfaces are used as their cages</source>
        <translation>サブディビジョンサーフェスは、細分前の形を使います</translation>
    </message>
    <message>
        <source>its text is {encoding}, where UTF-8 is usual</source>
        <translation>文字コードは通常の UTF-8 ではなく {encoding} です</translation>
    </message>
    <message>
        <source>its unit is {unit:g} m; its size on the canvas does not follow from that</source>
        <translation>単位は {unit:g} m ですが、キャンバス上の大きさには使いません</translation>
    </message>
    <message>
        <source>its {kinds} are not used</source>
        <translation>{kinds} は使いません</translation>
    </message>
    <message>
        <source>keys behind the end of the cut: {names}</source>
        <translation>カットの終わりより後ろのキー：{names}</translation>
    </message>
    <message>
        <source>keys behind the new end, kept and not reached: {count}</source>
        <translation>新しい終わりより後ろのキー（残りますが使われません）：{count} 個</translation>
    </message>
    <message>
        <source>layer {name}: {drawings}</source>
        <translation>レイヤー {name}：{drawings}</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>レイヤー</translation>
    </message>
    <message>
        <source>layered frames</source>
        <translation>レイヤー付きフレーム</translation>
    </message>
    <message>
        <source>layers.{layer}: it joins a layer that is no figure of its own</source>
        <translation>layers.{layer}：独立したキャラクターではないレイヤーに結合されています</translation>
    </message>
    <message>
        <source>layers.{layer}: its drawings are on different paper</source>
        <translation>layers.{layer}：セルごとに紙の扱いが違います</translation>
    </message>
    <message>
        <source>left alone</source>
        <comment>cuts</comment>
        <translation>変更なし</translation>
    </message>
    <message>
        <source>left alone, as nothing changed</source>
        <comment>a cut</comment>
        <translation>変更がないため、そのまま</translation>
    </message>
    <message>
        <source>left out, as they are cut to what is below them: {names}</source>
        <translation>下のレイヤーでクリッピングされているため読み込みませんでした：{names}</translation>
    </message>
    <message>
        <source>left out, as they are empty: {names}</source>
        <translation>空のため読み込みませんでした：{names}</translation>
    </message>
    <message>
        <source>left out, as they are guides: {names}</source>
        <translation>参考用レイヤーのため読み込みませんでした：{names}</translation>
    </message>
    <message>
        <source>left out, as they are hidden: {names}</source>
        <translation>非表示のため読み込みませんでした：{names}</translation>
    </message>
    <message>
        <source>left out, as they are of a kind that is not read: {names}</source>
        <translation>読み込めない種類のため読み込みませんでした：{names}</translation>
    </message>
    <message>
        <source>left out, as they do not lie plainly on what is below them: {names}</source>
        <translation>描画モードが通常ではないため読み込みませんでした：{names}</translation>
    </message>
    <message>
        <source>lengths that would leave their range and are kept at its end: {count}</source>
        <translation>範囲を超えるため上限・下限にとどめた長さの値：{count} 個</translation>
    </message>
    <message>
        <source>light and ground</source>
        <translation>ライトと地面</translation>
    </message>
    <message>
        <source>light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>line {number} cannot be understood: {text!r}</source>
        <translation>{number} 行目を読み取れません：{text!r}</translation>
    </message>
    <message>
        <source>line {number} has a comma in a number: {text!r}; please export it with decimal points</source>
        <translation>{number} 行目の数値にコンマがあります：{text!r}。小数点にはピリオドを使って書き出し直してください</translation>
    </message>
    <message>
        <source>lines that are parallel in the picture do not tell the field of view: it stays at {fov}°</source>
        <translation>画像の中で平行な線からは画角が分かりません：{fov}° のままです</translation>
    </message>
    <message>
        <source>made</source>
        <comment>a cut</comment>
        <translation>完成</translation>
    </message>
    <message>
        <source>made</source>
        <comment>cuts</comment>
        <translation>完成</translation>
    </message>
    <message>
        <source>markers and notes behind the new end: {count}</source>
        <translation>新しい終わりより後ろのマーカーとメモ：{count} 個</translation>
    </message>
    <message>
        <source>marks of a kind not known here are passed over: {count}</source>
        <translation>未知の記号は使いません：{count} 個</translation>
    </message>
    <message>
        <source>marks of inbetweens and reverse sheets (○ ●) are not used: {count}</source>
        <translation>中割り・逆シートの記号（○ ●）は使いません：{count} 個</translation>
    </message>
    <message>
        <source>mattes</source>
        <translation>マット</translation>
    </message>
    <message>
        <source>more than {most} layers</source>
        <translation>レイヤーが {most} 枚を超えています</translation>
    </message>
    <message>
        <source>moving for {frames} frames</source>
        <translation>{frames} コマ動きます</translation>
    </message>
    <message>
        <source>near the lamp the shadow turns round while the figure travels; the sun, or a lamp farther off, keeps its direction</source>
        <translation>ライトが近いため、キャラクターの移動につれて影の向きが回ります。太陽光にするか、ライトを遠ざけると向きが保たれます</translation>
    </message>
    <message>
        <source>no alpha channel: white that reaches the border was taken as clear</source>
        <translation>アルファチャンネルがないため、画像の縁につながる白を透明として扱いました</translation>
    </message>
    <message>
        <source>no key goes before the first frame</source>
        <translation>キーは最初のフレームより前には行けません</translation>
    </message>
    <message>
        <source>no key goes before the first frame, nor past the key that stays</source>
        <translation>キーは最初のフレームより前にも、止まっているキーの先にも行けません</translation>
    </message>
    <message>
        <source>no picture was saved with its layers, so they could not be compared with one</source>
        <translation>統合画像が保存されていないため、レイヤーを比べられませんでした</translation>
    </message>
    <message>
        <source>no shadow is seen: ground.receives is off, and no set piece receives</source>
        <translation>影が見えません：地面の「影を受ける」がオフで、影を受けるセットもありません</translation>
    </message>
    <message>
        <source>not handed on to {hook}, as the export is not whole</source>
        <translation>書き出しが完全でないため、{hook} には渡していません</translation>
    </message>
    <message>
        <source>not meant by the pattern: {names}</source>
        <translation>パターンに合わないため使わなかったもの：{names}</translation>
    </message>
    <message>
        <source>not taken: {parts}</source>
        <translation>取り込みなし：{parts}</translation>
    </message>
    <message>
        <source>not used of it: {names} and {count} more</source>
        <translation>使わないもの：{names} ほか {count} 個</translation>
    </message>
    <message>
        <source>not used of it: {names}</source>
        <translation>使わないもの：{names}</translation>
    </message>
    <message>
        <source>note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>nothing fills the canvas: where half-clear shadows lie on each other there, OpenToonz mixes them in its own way; put something opaque under them</source>
        <translation>キャンバスを埋めるものがありません。半透明の影が重なるところは OpenToonz では混ざり方が違います。下に不透明なものを置いてください</translation>
    </message>
    <message>
        <source>nothing is drawn</source>
        <translation>何も描かれていません</translation>
    </message>
    <message>
        <source>nothing is known of it: it was not made here, or the machine that did left no word</source>
        <translation>記録がありません。ここで作られていないか、作ったマシンが記録を残していません</translation>
    </message>
    <message>
        <source>nothing moved in it for too long, so it was ended</source>
        <translation>長い間まったく進まなかったため、終了させました</translation>
    </message>
    <message>
        <source>numbered frames for any compositing program</source>
        <translation>どの合成ソフトでも使える連番画像</translation>
    </message>
    <message>
        <source>of its variants these are used: {names}</source>
        <translation>バリアントは次のものを使います：{names}</translation>
    </message>
    <message>
        <source>of its {count} pictures the first alone is used</source>
        <translation>{count} 枚の画像のうち最初の 1 枚だけを使います</translation>
    </message>
    <message>
        <source>of its {count} scenes only {name!r} is read</source>
        <translation>{count} 個のシーンのうち {name!r} だけを読みます</translation>
    </message>
    <message>
        <source>of its {count} sheets {name} is used, not {others}</source>
        <translation>{count} 枚のシートのうち {name} を使います（使わないもの：{others}）</translation>
    </message>
    <message>
        <source>of several cels on one frame the first counts: {count} times</source>
        <translation>1 コマに複数のセルがある箇所は最初のものを使います：{count} か所</translation>
    </message>
    <message>
        <source>of two with one number only one counts: {names}</source>
        <translation>同じ番号のものは一方だけを使います：{names}</translation>
    </message>
    <message>
        <source>of work, cut by cut</source>
        <translation>処理時間の合計</translation>
    </message>
    <message>
        <source>one PSD or EXR a frame with all layers, to paint on</source>
        <translation>全レイヤー入りの PSD / EXR を 1 フレーム 1 枚で。加筆用</translation>
    </message>
    <message>
        <source>one sequence, although the words in its names differ: {first}, {last}</source>
        <translation>名前の語は違いますが 1 つの連番とみなしました：{first}、{last}</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>平行投影</translation>
    </message>
    <message>
        <source>other files that it calls are not read</source>
        <translation>呼び出されている別のファイルは読みません</translation>
    </message>
    <message>
        <source>paper is one of {papers}, not {text!r}</source>
        <translation>paper に使えるのは {papers} です。{text!r} は使えません</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>透視投影</translation>
    </message>
    <message>
        <source>printable text without spaces around it</source>
        <translation>前後に空白のない表示可能な文字列</translation>
    </message>
    <message>
        <source>project of {width} × {height} px, frames {frames} at {rate:g} a second</source>
        <translation>{width} × {height} px のプロジェクト、コマ {frames}、毎秒 {rate:g} コマ</translation>
    </message>
    <message>
        <source>property</source>
        <translation>プロパティ</translation>
    </message>
    <message>
        <source>reading it takes longer than {seconds} seconds: given up</source>
        <translation>読み込みに {seconds} 秒以上かかるため中止しました</translation>
    </message>
    <message>
        <source>reading sets in USD files</source>
        <translation>USD ファイルのセットの読み込み</translation>
    </message>
    <message>
        <source>reading sets that are compressed with Draco</source>
        <translation>Draco で圧縮されたセットの読み込み</translation>
    </message>
    <message>
        <source>received shadows</source>
        <translation>受けた影</translation>
    </message>
    <message>
        <source>reflections</source>
        <translation>映り込み</translation>
    </message>
    <message>
        <source>replaced keys: {count}</source>
        <translation>置き換わるキー：{count}</translation>
    </message>
    <message>
        <source>script</source>
        <translation>スクリプト</translation>
    </message>
    <message>
        <source>set of {count} triangles, {x:.6g} × {y:.6g} × {z:.6g} units, {up} points up</source>
        <translation>三角形 {count} 個のセット、{x:.6g} × {y:.6g} × {z:.6g} 単位、上方向は {up}</translation>
    </message>
    <message>
        <source>set piece {name}</source>
        <translation>セットの部品 {name}</translation>
    </message>
    <message>
        <source>several numbers run; the drawing&apos;s is taken to be {number} in {first}</source>
        <translation>変化する番号が複数あります。{first} では {number} をセルの番号とみなしました</translation>
    </message>
    <message>
        <source>shadow frames of the set</source>
        <translation>セットの影の連番</translation>
    </message>
    <message>
        <source>shadow frames</source>
        <translation>影の連番</translation>
    </message>
    <message>
        <source>something of this name is in the way</source>
        <translation>同じ名前のものがあります</translation>
    </message>
    <message>
        <source>standing still</source>
        <translation>静止</translation>
    </message>
    <message>
        <source>still to be made</source>
        <comment>cuts</comment>
        <translation>未完成</translation>
    </message>
    <message>
        <source>stopped</source>
        <comment>a cut</comment>
        <translation>中断</translation>
    </message>
    <message>
        <source>stops at its neighbour; Alt or A goes over it</source>
        <translation>隣で止まります（Alt か A で越えます）</translation>
    </message>
    <message>
        <source>taken as one, of which the newest counts: {names}; older drawings: {old}</source>
        <translation>同じものの版とみなし最新のものを使います：{names}（使わない古いセル：{old} 枚）</translation>
    </message>
    <message>
        <source>taken from {name}: {parts}</source>
        <translation>{name} から取り込み：{parts}</translation>
    </message>
    <message>
        <source>the anchor of {layer!r} moves by eases for x and for y, which After Effects has not for anchors; it has keys on its frames instead</source>
        <translation>{layer!r} のアンカーは x と y が別々のイーズで動きますが、After Effects のアンカーポイントにはそれがないため、代わりに各フレームにキーを打ちました</translation>
    </message>
    <message>
        <source>the camera looks at the middle of the new picture: shadows in perspective change a little</source>
        <translation>カメラは新しい画面の中央を向くため、遠近のある影が少し変わります</translation>
    </message>
    <message>
        <source>the command {command!r} has no end: {cause}</source>
        <translation>コマンド {command!r} が途中で切れています：{cause}</translation>
    </message>
    <message>
        <source>the control Height does not move {names}</source>
        <translation>コントロール「Height」では {names} は動きません</translation>
    </message>
    <message>
        <source>the cut ends here</source>
        <translation>カットはここで終わりです</translation>
    </message>
    <message>
        <source>the export is whole, but {what}</source>
        <translation>書き出しは完全ですが、{what}</translation>
    </message>
    <message>
        <source>the extensions {names} are not used</source>
        <translation>拡張機能 {names} は使いません</translation>
    </message>
    <message>
        <source>the figure is cut off by the lower edge of the drawing</source>
        <translation>キャラクターがセルの下端で切れています</translation>
    </message>
    <message>
        <source>the figure rests on a broad base: a hem, or it sits or lies</source>
        <translation>キャラクターが広い面で接地しています（裾、座り、寝そべりなど）</translation>
    </message>
    <message>
        <source>the file is damaged (a colour is not in its palette)</source>
        <translation>ファイルが壊れています（パレットにない色があります）</translation>
    </message>
    <message>
        <source>the first frame is shown as {first}; files that are exported and the command line count from 1</source>
        <translation>先頭のフレームを {first} と表示します。書き出すファイルとコマンドラインでは 1 から数えます</translation>
    </message>
    <message>
        <source>the head of {figure}&apos;s long shadow falls beside the picture on frame {frame}, as it does under any sun</source>
        <translation>フレーム {frame} で {figure} の長い影の頭が画面の外に落ちます。太陽をどこに置いても外れます</translation>
    </message>
    <message>
        <source>the head of {figure}&apos;s long shadow falls beside the picture on frame {frame}: light.azimuth = {azimuth} and light.elevation = {elevation} keep it there</source>
        <translation>フレーム {frame} で {figure} の長い影の頭が画面の外に落ちます。light.azimuth = {azimuth}、light.elevation = {elevation} にすると画面内に収まります</translation>
    </message>
    <message>
        <source>the lamp is in the plane of {figure}&apos;s drawing on frame {frame}, so there is next to no shadow: light.overhead_radius = {radius} makes four of it, and another z brings it out of that plane</source>
        <translation>フレーム {frame} でライトが {figure} のセルの平面内にあるため、影がほとんど出ません。light.overhead_radius = {radius} にすると四つのライトに分かれます。z を変えると平面から外れます</translation>
    </message>
    <message>
        <source>the lamp is straight above {figure} on frame {frame}: it is four lamps there, whose shadows are simplified to one (light.overhead_radius, light.overhead_simplify)</source>
        <translation>フレーム {frame} でライトが {figure} の真上にあります。そこでは四つのライトに分かれ、その影は単純化されて一つになります（light.overhead_radius、light.overhead_simplify）</translation>
    </message>
    <message>
        <source>the layer {layer} has no alpha of its own; that of the file is used</source>
        <translation>レイヤー {layer} には自分のアルファがないため、ファイルのアルファを使います</translation>
    </message>
    <message>
        <source>the layer {layer} is used, which has no alpha</source>
        <translation>使用するレイヤー {layer} にはアルファがありません</translation>
    </message>
    <message>
        <source>the light is the sun now: near a lamp the shadow would turn round while the figure travels</source>
        <translation>ライトを太陽にしました：ライトの近くでは、キャラクターの移動につれて影の向きが回ってしまうためです</translation>
    </message>
    <message>
        <source>the light that another style had brought was taken back</source>
        <translation>前のスタイルが入れたライトを元に戻しました</translation>
    </message>
    <message>
        <source>the line that names its format is missing</source>
        <translation>形式を示す先頭行がありません</translation>
    </message>
    <message>
        <source>the newest retake counts: {names}</source>
        <translation>最新のリテイクを使います：{names}</translation>
    </message>
    <message>
        <source>the newest version counts; older drawings left out: {count} ({names})</source>
        <translation>最新の版を使います。使わない古いセル：{count} 枚（{names}）</translation>
    </message>
    <message>
        <source>the opacity of these layers is not used: {names}</source>
        <translation>次のレイヤーの不透明度は使われません：{names}</translation>
    </message>
    <message>
        <source>the picture of the background keeps its own size in px</source>
        <translation>背景の画像は元のピクセルサイズのままです</translation>
    </message>
    <message>
        <source>the picture saved with its layers is empty, so they could not be compared with it</source>
        <translation>保存済みの統合画像が空のため、レイヤーを比べられませんでした</translation>
    </message>
    <message>
        <source>the pictures of the background are not a sequence without gaps, so they were copied</source>
        <translation>背景の画像は欠番のない連番ではないため、コピーしました</translation>
    </message>
    <message>
        <source>the process that reads USD cannot be started</source>
        <translation>USD を読むプロセスを起動できません</translation>
    </message>
    <message>
        <source>the same already: {parts}</source>
        <translation>すでに同じ：{parts}</translation>
    </message>
    <message>
        <source>the set is made of {count} parts, more than the {most} that are drawn while you work: left out here, but not of what is exported: {names}</source>
        <translation>セットは {count} 個の部分からできていて、作業中に描ける {most} 個を超えています。ここでは省きますが、書き出しには入ります：{names}</translation>
    </message>
    <message>
        <source>the sides have another proportion: what was the picture is now the middle {width} × {height} px</source>
        <translation>縦横比が異なるため、これまでの画面は中央の {width} × {height} px になります</translation>
    </message>
    <message>
        <source>the slowest first</source>
        <translation>時間のかかった順</translation>
    </message>
    <message>
        <source>the soft edges of drawn shapes are not done: {names}</source>
        <translation>シェイプのぼかしは行いません：{names}</translation>
    </message>
    <message>
        <source>the timesheet is of scene {scene!r}, cut {cut!r}; the project keeps {own_scene!r} and {own_cut!r}</source>
        <translation>タイムシートはシーン {scene!r}、カット {cut!r} のものです。プロジェクトの {own_scene!r}、{own_cut!r} はそのままにしました</translation>
    </message>
    <message>
        <source>the timesheet: {note}</source>
        <translation>タイムシート：{note}</translation>
    </message>
    <message>
        <source>the window can only be measured on an X server with its test extension (libX11, libXtst)</source>
        <translation>ウィンドウの測定には、テスト拡張付きの X サーバーが必要です（libX11、libXtst）</translation>
    </message>
    <message>
        <source>there are no drawings that could take the place of those of the layer</source>
        <translation>レイヤーのセルと差し替えられるセルがありません</translation>
    </message>
    <message>
        <source>there are no triangles in it: {why}</source>
        <translation>三角形がありません：{why}</translation>
    </message>
    <message>
        <source>there is no character in it whose look could be taken</source>
        <translation>見た目を取り込めるキャラクターがありません</translation>
    </message>
    <message>
        <source>there is no drawing</source>
        <translation>セルがありません</translation>
    </message>
    <message>
        <source>there is no layer {address!r} in it, but there are: {names}</source>
        <translation>レイヤー {address!r} がありません。あるのは {names} です</translation>
    </message>
    <message>
        <source>there is no layer {name!r} in this project; did you mean {near!r}?</source>
        <translation>このプロジェクトにレイヤー {name!r} はありません（{near!r} ではありませんか？）</translation>
    </message>
    <message>
        <source>there is no layer {name!r} to be joined</source>
        <translation>結合先のレイヤー {name!r} がありません</translation>
    </message>
    <message>
        <source>there is no matte {matte!r}, only {mattes}</source>
        <translation>{matte!r} というマットはありません。あるのは {mattes} だけです</translation>
    </message>
    <message>
        <source>there is no picture in this folder</source>
        <translation>このフォルダーに画像がありません</translation>
    </message>
    <message>
        <source>there is no picture yet</source>
        <translation>まだ絵がありません</translation>
    </message>
    <message>
        <source>there is no property {path!r} in this project</source>
        <translation>このプロジェクトにプロパティ {path!r} はありません</translation>
    </message>
    <message>
        <source>there is no property {path!r} in this project; did you mean {near}?</source>
        <translation>このプロジェクトにプロパティ {path!r} はありません（{near} ではありませんか？）</translation>
    </message>
    <message>
        <source>there is no style {style!r}{hint}</source>
        <translation>スタイル {style!r} はありません{hint}</translation>
    </message>
    <message>
        <source>there is no such layer</source>
        <translation>そのようなレイヤーはありません</translation>
    </message>
    <message>
        <source>there is no such property</source>
        <translation>そのようなプロパティはありません</translation>
    </message>
    <message>
        <source>there is not enough memory for this set</source>
        <translation>このセットを読み込むにはメモリーが足りません</translation>
    </message>
    <message>
        <source>there is nothing to render: the project has no visible character layer</source>
        <translation>レンダリングするものがありません。表示されているキャラクターのレイヤーがありません</translation>
    </message>
    <message>
        <source>there is only a background in it</source>
        <translation>背景しかありません</translation>
    </message>
    <message>
        <source>these lines cannot be square to each other on one floor</source>
        <translation>この線の組は同じ床の上で直交しません</translation>
    </message>
    <message>
        <source>this bundle has it not; an installation in a Python can have it</source>
        <translation>このバンドルには含まれていません。Python にインストールしたものでは使えます</translation>
    </message>
    <message>
        <source>this is not a set that can be read; readable are {mesh_suffixes}</source>
        <translation>読み込めるセットではありません。対応形式は {mesh_suffixes} です</translation>
    </message>
    <message>
        <source>this point of the set is not before the camera on every frame</source>
        <translation>セットのこの点がカメラの前にないフレームがあります</translation>
    </message>
    <message>
        <source>this project needs Kagezou {program} or newer (format version {number}); this is Kagezou {own}</source>
        <translation>このプロジェクトには Kagezou {program} 以降が要ります（形式のバージョン {number}）。これは Kagezou {own} です</translation>
    </message>
    <message>
        <source>this project needs a newer Kagezou (format version {number}); this is Kagezou {own}</source>
        <translation>このプロジェクトには新しい Kagezou が要ります（形式のバージョン {number}）。これは Kagezou {own} です</translation>
    </message>
    <message>
        <source>this was not done, as the project could not be saved any more: {cause}</source>
        <translation>プロジェクトを保存できなくなるため、この操作は行いませんでした：{cause}</translation>
    </message>
    <message>
        <source>time</source>
        <translation>秒＋コマ</translation>
    </message>
    <message>
        <source>timed by {path}</source>
        <translation>タイミングは {path} から取りました</translation>
    </message>
    <message>
        <source>timesheet {name!r} of {frames} frames</source>
        <translation>タイムシート {name!r}、{frames} コマ</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true または false</translation>
    </message>
    <message>
        <source>true</source>
        <translation>true</translation>
    </message>
    <message>
        <source>united shadows</source>
        <translation>まとめた影</translation>
    </message>
    <message>
        <source>video</source>
        <translation>動画</translation>
    </message>
    <message>
        <source>waiting</source>
        <comment>a cut</comment>
        <translation>待機中</translation>
    </message>
    <message>
        <source>what could be its alpha is 0 everywhere and was taken as unused</source>
        <translation>アルファらしきチャンネルが全面 0 のため、使われていないものとみなしました</translation>
    </message>
    <message>
        <source>what lies behind its last frame is not used: {count} entries</source>
        <translation>最後のコマより後の記入は使いません：{count} 件</translation>
    </message>
    <message>
        <source>what lies beyond the smaller picture is kept and not seen</source>
        <translation>小さくなった画面からはみ出した部分は残りますが、表示されません</translation>
    </message>
    <message>
        <source>what looks like a version is taken as the drawing&apos;s number: {first}</source>
        <translation>版に見える数字をセルの番号とみなしました：{first}</translation>
    </message>
    <message>
        <source>what stands behind its end is not used</source>
        <translation>末尾の後ろにあるものは使いません</translation>
    </message>
    <message>
        <source>what was written reads otherwise</source>
        <translation>書き込んだ内容と読み込んだ内容が一致しません</translation>
    </message>
    <message>
        <source>with doubtful drawings</source>
        <translation>要確認のセルあり</translation>
    </message>
    <message>
        <source>with {megabytes} MB it is larger than can be read</source>
        <translation>{megabytes} MB は大きすぎて読み込めません</translation>
    </message>
    <message>
        <source>work_area: frames {first} to {last} are not a range of frames</source>
        <translation>work_area：フレーム {first} から {last} は時間の範囲になっていません</translation>
    </message>
    <message>
        <source>writing videos needs a part that is not installed</source>
        <translation>動画の書き出しに必要な部品が入っていません</translation>
    </message>
    <message>
        <source>writing videos</source>
        <translation>動画の書き出し</translation>
    </message>
    <message>
        <source>{cause}</source>
        <translation>{cause}</translation>
    </message>
    <message>
        <source>{count} bytes behind its end are not used</source>
        <translation>終わりの後ろの {count} バイトは使いません</translation>
    </message>
    <message>
        <source>{count} bytes behind its last triangle are not used</source>
        <translation>最後の三角形の後ろの {count} バイトは使いません</translation>
    </message>
    <message>
        <source>{count} characters have one drawing each and are seen together: {names}</source>
        <translation>{count} 人のキャラクターはセルが 1 枚ずつで、同時に表示されます：{names}</translation>
    </message>
    <message>
        <source>{count} drawings are missing: {names}</source>
        <translation>{count} 枚のセルが見つかりません：{names}</translation>
    </message>
    <message>
        <source>{count} drawings</source>
        <translation>セル {count} 枚</translation>
    </message>
    <message>
        <source>{count} files lie outside the project&apos;s folder and are only read, never written: {folders}</source>
        <translation>プロジェクトのフォルダ外のファイルが{count}個あります（読み込むだけで、書き込みません）：{folders}</translation>
    </message>
    <message>
        <source>{count} frames at {rate} fps</source>
        <translation>{count} フレーム・{rate} fps</translation>
    </message>
    <message>
        <source>{count} keyed properties got a key on frame {frame}: {names}</source>
        <translation>キーのあるプロパティ {count} 個の {frame} フレームにキーを打ちました：{names}</translation>
    </message>
    <message>
        <source>{count} of its faces cross or touch themselves: every loop is filled</source>
        <translation>自己交差または自己接触している面が {count} 個あり、輪のそれぞれを塗りつぶします</translation>
    </message>
    <message>
        <source>{count} of its faces have fewer than three corners and are not used</source>
        <translation>頂点が 3 つ未満の面が {count} 個あり、使いません</translation>
    </message>
    <message>
        <source>{count} of its faces have too many corners or cross themselves too often and are left out</source>
        <translation>頂点または自己交差が多すぎる面が {count} 個あり、省きます</translation>
    </message>
    <message>
        <source>{count} of its facets are no triangles and are not used</source>
        <translation>三角形でないファセットが {count} 個あり、使いません</translation>
    </message>
    <message>
        <source>{count} of its instancers put nothing</source>
        <translation>何も配置しないインスタンサーが {count} 個あります</translation>
    </message>
    <message>
        <source>{count} of its meshes hang on no node and are not used</source>
        <translation>{count} 個のメッシュはどのノードにも付いていないため使いません</translation>
    </message>
    <message>
        <source>{count} of its nodes are hidden, and what hangs on them</source>
        <translation>{count} 個のノードは非表示なので、その下にあるものも含めて使いません</translation>
    </message>
    <message>
        <source>{count} of its prototypes are missing</source>
        <translation>プロトタイプが {count} 個見つかりません</translation>
    </message>
    <message>
        <source>{count} of its shapes are guides and are not used</source>
        <translation>ガイド用の形状が {count} 個あり、使いません</translation>
    </message>
    <message>
        <source>{count} of its shapes are proxies for others and are not used</source>
        <translation>プロキシ用の形状が {count} 個あり、使いません</translation>
    </message>
    <message>
        <source>{count} of its skins stand as they were modelled, without their pose</source>
        <translation>{count} 個のスキンはポーズなしの、モデリング時の形を使います</translation>
    </message>
    <message>
        <source>{count} of its triangles have a corner that is not a number</source>
        <translation>頂点が数値でない三角形が {count} 個あり、省きます</translation>
    </message>
    <message>
        <source>{count} {kind}</source>
        <translation>{kind} {count}</translation>
    </message>
    <message>
        <source>{failed} of {files} frames failed</source>
        <translation>{files} フレーム中 {failed} フレームが失敗しました</translation>
    </message>
    <message>
        <source>{figure} pokes through {piece} on frame {frame}, which cuts its shadow: more room behind the figure, or upright = 1, keeps it whole</source>
        <translation>フレーム {frame} で {figure} が {piece} を突き抜けていて、影が切れます：キャラクターの後ろをもっと空けるか、upright = 1 にすると切れません</translation>
    </message>
    <message>
        <source>{figure}&apos;s long shadow runs up the background on frame {frame}, for without perspective the ground has no horizon: camera.fov, or matching the camera to the picture, lays it down</source>
        <translation>フレーム {frame} で {figure} の長い影が背景を駆け上がっています。遠近がないと地面に地平線がありません。camera.fov か背景へのカメラ合わせで寝かせられます</translation>
    </message>
    <message>
        <source>{figure}: on frame {frame} its two grounding points leave {percent:.0f} % of the shadow that one has; feet or one point keep it whole</source>
        <translation>{figure}：フレーム {frame} では接地点が 2 つあるため、影が 1 点のときの {percent:.0f} % しか残りません。足または接地点 1 つなら保たれます</translation>
    </message>
    <message>
        <source>{folder}: it holds {name}, which is no part of a bundle; a bundle needs a folder of its own</source>
        <translation>{folder}：バンドルではない {name} が入っています。バンドルには専用のフォルダーが必要です</translation>
    </message>
    <message>
        <source>{folder}: the drawings of {layer!r} lie there themselves and would be replaced by their copies; please choose another folder</source>
        <translation>{folder}：{layer!r} のセルそのものがここにあり、コピーで置き換えられてしまいます。別のフォルダーを選んでください</translation>
    </message>
    <message>
        <source>{folder}: the job renders there; its bundle needs a folder of its own</source>
        <translation>{folder}：ジョブの出力先です。バンドルには専用のフォルダーが必要です</translation>
    </message>
    <message>
        <source>{folder}: the pictures of the background lie there themselves and would be replaced by their copies; please choose another folder</source>
        <translation>{folder}：背景の画像そのものがここにあり、コピーで置き換えられてしまいます。別のフォルダーを選んでください</translation>
    </message>
    <message>
        <source>{folder}: {files} files need at least {needed} MB, but only {free} MB are free on the disk</source>
        <translation>{folder}：{files} 個のファイルには {needed} MB 以上が要りますが、ディスクの空きは {free} MB しかありません</translation>
    </message>
    <message>
        <source>{format} frames have {depths} bits a channel, not {depth}</source>
        <translation>{format} のフレームは 1 チャンネル {depths} ビットです。{depth} にはできません</translation>
    </message>
    <message>
        <source>{found} of {count} missing files were found</source>
        <translation>見つからないファイル {count} 個のうち {found} 個が見つかりました</translation>
    </message>
    <message>
        <source>{frame!r}, {component!r} are not a frame and a component, whole numbers from 1</source>
        <translation>{frame!r}、{component!r} はフレームと成分（1 からの整数）ではありません</translation>
    </message>
    <message>
        <source>{hook} cannot be run: {cause}</source>
        <translation>{hook} を実行できません：{cause}</translation>
    </message>
    <message>
        <source>{hook} failed with code {code}</source>
        <translation>{hook} が終了コード {code} で失敗しました</translation>
    </message>
    <message>
        <source>{hook} failed with code {code}: {said}</source>
        <translation>{hook} がコード {code} で失敗しました：{said}</translation>
    </message>
    <message>
        <source>{hook} was stopped; the export is whole</source>
        <translation>{hook} を止めました。書き出しは完全です</translation>
    </message>
    <message>
        <source>{label!r} is no colour of a label: {known}</source>
        <translation>{label!r} はラベルの色ではありません：{known}</translation>
    </message>
    <message>
        <source>{layer} has vector shapes that cannot be drawn</source>
        <translation>{layer} に描画できないベクターシェイプがあります</translation>
    </message>
    <message>
        <source>{layer}: receives is on, but there is no other character whose shadow could fall on it</source>
        <translation>{layer}：「影を受ける」がオンですが、影を落とすほかのキャラクターがいません</translation>
    </message>
    <message>
        <source>{layer}: the length of wave {number} is keyed, so that the cut does not loop</source>
        <translation>{layer}:波{number}の波長にキーがあるため、カットはループしません</translation>
    </message>
    <message>
        <source>{layer}: the timesheet has no column for it; it keeps its timing</source>
        <translation>{layer}：タイムシートに列がありません。タイミングはそのままです</translation>
    </message>
    <message>
        <source>{layer}: the timesheet names cels without a drawing; they stay empty: {missing}</source>
        <translation>{layer}：タイムシートのセルに当たる画像がなく、空セルになります：{missing}</translation>
    </message>
    <message>
        <source>{layer}: wave {number} goes {velocity:g} px a frame; crests that pass in the cut: {crests}</source>
        <translation>{layer}:波{number}は1フレームに{velocity:g} px進みます（カット内に通る波の山:{crests}）</translation>
    </message>
    <message>
        <source>{line}: a key cannot lie on frame {frame}, frames count from 1</source>
        <translation>{line}：フレーム {frame} にはキーを置けません。フレームは 1 から数えます</translation>
    </message>
    <message>
        <source>{line}: a switch or choice can only be held, not keyed {interpolation}</source>
        <translation>{line}：スイッチや選択肢のキーは停止だけです。{interpolation} にはできません</translation>
    </message>
    <message>
        <source>{names} and {count} more</source>
        <translation>{names} ほか {count} 点</translation>
    </message>
    <message>
        <source>{names} went to the end of the range: the character is very small or very tall</source>
        <translation>{names} は範囲の端の値にしました：キャラクターがとても小さいか、とても大きいためです</translation>
    </message>
    <message>
        <source>{names}: not there, so they look as {first} does</source>
        <translation>{names}：元にないため、{first} の見た目にしました</translation>
    </message>
    <message>
        <source>{names}: standing upright now, as the set does</source>
        <translation>{names}：セットと同じく、まっすぐに立つようになりました</translation>
    </message>
    <message>
        <source>{names}: the look of frame {frame} was taken, without keys</source>
        <translation>{names}：フレーム {frame} の見た目を、キーなしで取り込みました</translation>
    </message>
    <message>
        <source>{names}: there is no cut in it</source>
        <translation>{names}：カットがありません</translation>
    </message>
    <message>
        <source>{name} cannot be a part of its own figure</source>
        <translation>{name} は自分自身のキャラクターの部分にはできません</translation>
    </message>
    <message>
        <source>{name} cannot be the same for all characters</source>
        <translation>{name} は全キャラクター共通にできません</translation>
    </message>
    <message>
        <source>{name} is not a number of a project</source>
        <translation>{name} はプロジェクトに使える数ではありません</translation>
    </message>
    <message>
        <source>{name} is true or false, not {word!r}</source>
        <translation>{name} は true か false です（{word!r} は不可）</translation>
    </message>
    <message>
        <source>{name} {value}{unit} ({change}{unit})</source>
        <translation>{name} {value}{unit} ({change}{unit})</translation>
    </message>
    <message>
        <source>{name} {value}{unit}</source>
        <translation>{name} {value}{unit}</translation>
    </message>
    <message>
        <source>{name}: a drawing changed; its feet are those in the project (kagezou feet finds them anew)</source>
        <translation>{name}：セルが変わりました。足はプロジェクトのものを使っています（kagezou feet で探し直せます）</translation>
    </message>
    <message>
        <source>{name}: a layer holds one character; left out: {names}</source>
        <translation>{name}：1 つのレイヤーには 1 人のキャラクターだけです。除外：{names}</translation>
    </message>
    <message>
        <source>{name}: a shadow seems to be painted into its drawings, half-transparent at the base, and casts with them; layers.{name}.shadow.painted=left_out leaves it out</source>
        <translation>{name}：足元に半透明の影が描き込まれているようで、セルと一緒に影を落とします。layers.{name}.shadow.painted=left_out で除けます</translation>
    </message>
    <message>
        <source>{name}: drawings differ in size, first {path} with {width_px} × {height_px} px; each lies centred on the canvas</source>
        <translation>{name}：セルの大きさがそろっていません。最初にちがうのは {path} の {width_px} × {height_px} px です。どれもキャンバスの中央に置きます</translation>
    </message>
    <message>
        <source>{name}: its drawings have no alpha; pure white is taken as clear</source>
        <translation>{name}：セルにアルファがありません。純白を透明とみなします</translation>
    </message>
    <message>
        <source>{name}: its drawings have no alpha; white inside their outlines stays, also between arm and body, and white that reaches the border is taken as clear (layers.{name}.paper)</source>
        <translation>{name}：セルにアルファがありません。線の内側の白は残し（腕と体の間の白も残ります）、画像の縁につながる白を透明として扱います（layers.{name}.paper）</translation>
    </message>
    <message>
        <source>{name}: its drawings of {width} × {height} px reach over the canvas of {canvas} px</source>
        <translation>{name}：{width} × {height} px のセルが {canvas} px のキャンバスからはみ出しています</translation>
    </message>
    <message>
        <source>{name}: its numbers lie too far apart to be frames; each drawing has one</source>
        <translation>{name}：番号が離れすぎていてコマ番号とみなせないため、1 枚を 1 コマずつ並べました</translation>
    </message>
    <message>
        <source>{name}: missing {gaps}; the drawing before is held</source>
        <translation>{name}：{gaps} がありません。前のセルを止めて使います</translation>
    </message>
    <message>
        <source>{name}: missing, so left empty on frames {frames}: {names}</source>
        <translation>{name}：ファイルがないため、フレーム{frames}は空にしました：{names}</translation>
    </message>
    <message>
        <source>{name}: missing, so the nearest drawing is held on frames {frames}: {names}</source>
        <translation>{name}：ファイルがないため、フレーム{frames}は前後の近いセルで止めました：{names}</translation>
    </message>
    <message>
        <source>{name}: newer retakes count instead of {names}</source>
        <translation>{name}：新しいリテイクを使い、{names} は使いません</translation>
    </message>
    <message>
        <source>{name}: no feet were found ({reason}), so it stands on the ground line</source>
        <translation>{name}：足が見つからないため ({reason})、接地ラインに立ちます</translation>
    </message>
    <message>
        <source>{name}: one drawing, {first}</source>
        <translation>{name}：1 枚、{first}</translation>
    </message>
    <message>
        <source>{name}: the figure reaches the lower edge of its drawing, where the ground was put; if its feet are cut off, move the ground to where they would stand</source>
        <translation>{name}：キャラクターがセルの下端まで届いているため、そこに地面を置きました。足が切れている場合は、足の立つ位置へ地面を動かしてください</translation>
    </message>
    <message>
        <source>{name}: there is nothing solid in its drawings; the whole canvas was taken as the figure</source>
        <translation>{name}：セルに不透明な部分がありません。キャンバス全体をキャラクターとみなしました</translation>
    </message>
    <message>
        <source>{name}: these are not drawn: {never}</source>
        <translation>{name}：描画されないもの：{never}</translation>
    </message>
    <message>
        <source>{name}: these are of other sizes than the document says, and lie about their middles: {names}</source>
        <translation>{name}：ドキュメントに書かれた大きさと違う画像があり、中心を合わせて置きました：{names}</translation>
    </message>
    <message>
        <source>{name}: two frames begin at {frame}; the later one is used</source>
        <translation>{name}：フレーム {frame} から始まるコマが 2 つあります。後のほうを使います</translation>
    </message>
    <message>
        <source>{name}: what is before the document&apos;s first frame is not used</source>
        <translation>{name}：ドキュメントの最初のフレームより前は使われません</translation>
    </message>
    <message>
        <source>{name}: which foot carries is doubtful on {count} drawings (frames {frames}); please look at them</source>
        <translation>{name}：{count} 枚のセルで接地足が疑わしいです（フレーム {frames}）。確認してください</translation>
    </message>
    <message>
        <source>{name}: words about feet that are not there any more: {names}</source>
        <translation>{name}：足がなくなったため除いた足の指定：{names}</translation>
    </message>
    <message>
        <source>{name}: {cause}</source>
        <translation>{name}：{cause}</translation>
    </message>
    <message>
        <source>{name}: {count} drawings cannot be opened</source>
        <translation>{name}：{count} 枚のセルを開けません</translation>
    </message>
    <message>
        <source>{name}: {count} drawings, {first} … {last}</source>
        <translation>{name}：{count} 枚、{first} … {last}</translation>
    </message>
    <message>
        <source>{name}: {count} drawings, {numbers}, {first} … {last}</source>
        <translation>{name}：{count} 枚、{numbers}、{first} … {last}</translation>
    </message>
    <message>
        <source>{name}: {count} keys went along with their drawings</source>
        <translation>{name}：キー {count} 個がセルと一緒に移動しました</translation>
    </message>
    <message>
        <source>{name}: {note}, in all its {count} files</source>
        <translation>{name}：{note}（{count} 個のファイルすべて）</translation>
    </message>
    <message>
        <source>{name}: {note}, in {files} of {count} files, first in {path}</source>
        <translation>{name}：{note}（{count} 個中 {files} 個、最初は {path}）</translation>
    </message>
    <message>
        <source>{name}: {same} drawings are as before, {changed} are other pictures, {new} are new, {gone} are gone</source>
        <translation>{name}：前と同じセル {same} 枚、変わったセル {changed} 枚、新しいセル {new} 枚、なくなったセル {gone} 枚</translation>
    </message>
    <message>
        <source>{part} is a part of {figure} and has no shadow of its own; please ask for {figure}</source>
        <translation>{part} は {figure} の一部で、独自の影を持ちません。{figure} を指定してください</translation>
    </message>
    <message>
        <source>{part}: there is no character {name!r} that it could join</source>
        <translation>{part}：結合先のキャラクター {name!r} がありません</translation>
    </message>
    <message>
        <source>{path} cannot be read: {cause}</source>
        <translation>{path}：読み込めません：{cause}</translation>
    </message>
    <message>
        <source>{path} cannot be {word!r}</source>
        <translation>{path} を {word!r} にはできません</translation>
    </message>
    <message>
        <source>{path} does not hold shortcuts: {cause}</source>
        <translation>{path} はショートカットのファイルではありません：{cause}</translation>
    </message>
    <message>
        <source>{path} does not hold values: {cause}</source>
        <translation>{path} は値のファイルではありません：{cause}</translation>
    </message>
    <message>
        <source>{path} is not a style: {cause}</source>
        <translation>{path} はスタイルではありません：{cause}</translation>
    </message>
    <message>
        <source>{path} is not an export preset: {cause}</source>
        <translation>{path} は書き出しプリセットではありません：{cause}</translation>
    </message>
    <message>
        <source>{path} is the same on every frame and has no keys</source>
        <translation>{path} は全フレーム共通で、キーは打てません</translation>
    </message>
    <message>
        <source>{path}: &apos;{path_suffix}&apos; cannot be written, only {formats}</source>
        <translation>{path}：「{path_suffix}」では書き出せません。使えるのは {formats} です</translation>
    </message>
    <message>
        <source>{path}: a folder of cuts in a folder of cuts is not looked into; name it itself</source>
        <translation>{path}：カットのフォルダーの中にあるカットのフォルダーは読みません。直接指定してください</translation>
    </message>
    <message>
        <source>{path}: a job is not written among the cuts that it makes</source>
        <translation>{path}：ジョブは、それが作るカットのフォルダーの中には書き込めません</translation>
    </message>
    <message>
        <source>{path}: a project cannot name files of a network share it does not lie on; give the share a drive letter or save the project there</source>
        <translation>{path}：プロジェクトは別のネットワーク共有にあるファイルを指せません。共有にドライブ文字を割り当てるか、プロジェクトをそこに保存してください</translation>
    </message>
    <message>
        <source>{path}: a switch or choice can only be held</source>
        <translation>{path}：スイッチや選択肢のキーは停止だけです</translation>
    </message>
    <message>
        <source>{path}: a video ends in .mp4 or .mov</source>
        <translation>{path}：動画の拡張子は .mp4 か .mov です</translation>
    </message>
    <message>
        <source>{path}: adjustment layers over drawings are not used: {names}</source>
        <translation>{path}：セルの上の調整レイヤーは使いません：{names}</translation>
    </message>
    <message>
        <source>{path}: another user changes it, or left {lock} beside it, which only they can remove</source>
        <translation>{path}：ほかのユーザーが変更中か、隣に {lock} を残しています。削除できるのはそのユーザーだけです</translation>
    </message>
    <message>
        <source>{path}: beside cuts, and none itself: {names}</source>
        <translation>{path}：カットの隣にあり、カットではないもの：{names}</translation>
    </message>
    <message>
        <source>{path}: beside it there are no drawings of its columns ({names}): neither folders of these names nor pictures such as A_0001.png nor PSD files with such groups</source>
        <translation>{path}：そばに列（{names}）のセルがありません。その名前のフォルダーも A_0001.png のような画像も、その名前のグループを持つ PSD もありません</translation>
    </message>
    <message>
        <source>{path}: cannot be removed: {cause}</source>
        <translation>{path}：削除できません：{cause}</translation>
    </message>
    <message>
        <source>{path}: cannot be saved: {cause}</source>
        <translation>{path}：保存できません：{cause}</translation>
    </message>
    <message>
        <source>{path}: cannot be written: no space left on the disk</source>
        <translation>{path}：書き込めません：ディスクに空きがありません</translation>
    </message>
    <message>
        <source>{path}: cannot be written: {cause}</source>
        <translation>{path}：書き込めません：{cause}</translation>
    </message>
    <message>
        <source>{path}: every layer in it is hidden or empty</source>
        <translation>{path}：すべてのレイヤーが非表示か空です</translation>
    </message>
    <message>
        <source>{path}: it is a drawing of the project and is not written over</source>
        <translation>{path}：プロジェクトのセルなので上書きしません</translation>
    </message>
    <message>
        <source>{path}: it is open in a window on {host}, which will ask before it saves over this</source>
        <translation>{path}：{host} のウィンドウで開かれています。そこで保存するときに、上書きするか確認が出ます</translation>
    </message>
    <message>
        <source>{path}: it lies outside the project&apos;s folder and is only read, never written</source>
        <translation>{path}：プロジェクトのフォルダ外にあります（読み込むだけで、書き込みません）</translation>
    </message>
    <message>
        <source>{path}: it means nothing for the kind {kind}</source>
        <translation>{path}：種類 {kind} では意味がありません</translation>
    </message>
    <message>
        <source>{path}: its values are held, and none lies between two of them</source>
        <translation>{path}：値はホールドされ、二つの値のあいだはありません</translation>
    </message>
    <message>
        <source>{path}: its {count} pages are its drawings, a frame each</source>
        <translation>{path}：{count} ページを 1 コマずつのセルとして読み込みました</translation>
    </message>
    <message>
        <source>{path}: its {count} pictures are its drawings, as long as it says at {rate} frames/s</source>
        <translation>{path}：{count} 枚の画像を、{rate} コマ/秒でファイルの表示時間どおりに、セルとして読み込みました</translation>
    </message>
    <message>
        <source>{path}: its {count} pictures are its drawings, as long as it says, rounded to whole frames at {rate} frames/s</source>
        <translation>{path}：{count} 枚の画像を、表示時間を {rate} コマ/秒のコマ単位に丸めて、セルとして読み込みました</translation>
    </message>
    <message>
        <source>{path}: its {count} pictures are its drawings; {unsaid} of them do not say how long they are seen, which counts as {ms:g} ms</source>
        <translation>{path}：{count} 枚の画像をセルとして読み込みました。{unsaid} 枚には表示時間の指定がないため、{ms:g} ms としました</translation>
    </message>
    <message>
        <source>{path}: keys are out of order</source>
        <translation>{path}：キーの順序が正しくありません</translation>
    </message>
    <message>
        <source>{path}: layers are written as {layered_formats}</source>
        <translation>{path}：レイヤー付きは {layered_formats} で書き出します</translation>
    </message>
    <message>
        <source>{path}: left out, as they are empty: {names}</source>
        <translation>{path}：空のため読み込まなかったもの：{names}</translation>
    </message>
    <message>
        <source>{path}: left out, as they are hidden: {names}</source>
        <translation>{path}：非表示のため読み込まなかったもの：{names}</translation>
    </message>
    <message>
        <source>{path}: left out, as they have no number: {names}</source>
        <translation>{path}：番号がないため使わなかった画像：{names}</translation>
    </message>
    <message>
        <source>{path}: none of its cels has a drawing among those of {layers}</source>
        <translation>{path}：シートのどのセルにも {layers} の画像が見つかりません</translation>
    </message>
    <message>
        <source>{path}: none of the missing drawings is there: {names}</source>
        <translation>{path}：見つからないセルはここにもありません：{names}</translation>
    </message>
    <message>
        <source>{path}: not taken into the cut: {names}</source>
        <translation>{path}：カットに取り込まなかったもの：{names}</translation>
    </message>
    <message>
        <source>{path}: not there: {names}</source>
        <translation>{path}：ここにないもの：{names}</translation>
    </message>
    <message>
        <source>{path}: one figure with one shadow: {names}</source>
        <translation>{path}：一つの影を持つ一体のキャラクター：{names}</translation>
    </message>
    <message>
        <source>{path}: somebody else has been changing it for a while; please try again</source>
        <translation>{path}：ほかのプログラムがしばらく変更を続けています。もう一度お試しください</translation>
    </message>
    <message>
        <source>{path}: the background is {taken}; left out: {names}</source>
        <translation>{path}：背景は {taken} です。取り込まなかったもの：{names}</translation>
    </message>
    <message>
        <source>{path}: the drawing is missing</source>
        <translation>{path}：セルが見つかりません</translation>
    </message>
    <message>
        <source>{path}: the folder of this cut is empty</source>
        <translation>{path}：このカットのフォルダーは空です</translation>
    </message>
    <message>
        <source>{path}: the kept work is damaged: {cause}</source>
        <translation>{path}：退避した作業が壊れています：{cause}</translation>
    </message>
    <message>
        <source>{path}: the layer {layer!r} was left out, as there is a background already</source>
        <translation>{path}：背景がすでにあるため、レイヤー {layer!r} は読み込みませんでした</translation>
    </message>
    <message>
        <source>{path}: the output would lie among the drawings of this cut; give it another folder</source>
        <translation>{path}：出力先がこのカットのセルの中になります。別のフォルダーを指定してください</translation>
    </message>
    <message>
        <source>{path}: the set is missing</source>
        <translation>{path}：セットが見つかりません</translation>
    </message>
    <message>
        <source>{path}: there is a cut of its name, so it is made as {name}</source>
        <translation>{path}：同じ名前のカットがあるため、{name} として作ります</translation>
    </message>
    <message>
        <source>{path}: there is no camera {camera!r} in it, only none at all</source>
        <translation>{path}：カメラ {camera!r} はありません。ほかのカメラもありません</translation>
    </message>
    <message>
        <source>{path}: there is no camera {camera!r} in it, only {known}</source>
        <translation>{path}：カメラ {camera!r} はありません。あるのは {known} です</translation>
    </message>
    <message>
        <source>{path}: there is no key before frame {frame} to ease from</source>
        <translation>{path}：フレーム {frame} より前に、イーズの始まりになるキーがありません</translation>
    </message>
    <message>
        <source>{path}: there is no sheet {which!r} in it, but {names}</source>
        <translation>{path}：シート {which!r} はありません。あるもの：{names}</translation>
    </message>
    <message>
        <source>{path}: these are not rules of path mapping: {cause}</source>
        <translation>{path}：パスマッピングの規則ではありません：{cause}</translation>
    </message>
    <message>
        <source>{path}: these lie simply over what is below them here: {names}</source>
        <translation>{path}：次のレイヤーは、ここでは通常の重ね方で描きます：{names}</translation>
    </message>
    <message>
        <source>{path}: this folder is not there</source>
        <translation>{path}：このフォルダーはありません</translation>
    </message>
    <message>
        <source>{path}: {cause}</source>
        <translation>{path}：{cause}</translation>
    </message>
    <message>
        <source>{path}: {note}</source>
        <translation>{path}: {note}</translation>
    </message>
    <message>
        <source>{path}: {text!r} is not JSON: a number, true, &quot;word&quot;, x,y or [x, y] or [[x, y], ...]</source>
        <translation>{path}：{text!r} は JSON ではありません（数、true、&quot;word&quot;、x,y、[x, y]、[[x, y], ...]）</translation>
    </message>
    <message>
        <source>{path}: {text!r} is not a whole number</source>
        <translation>{path}：{text!r} は整数ではありません</translation>
    </message>
    <message>
        <source>{path}: {where}: {problem}</source>
        <translation>{path}：{where}：{problem}</translation>
    </message>
    <message>
        <source>{path}: {where}: {value!r} is not kept in its canonical form</source>
        <translation>{path}：{where}：{value!r} は標準の形で保存されていません</translation>
    </message>
    <message>
        <source>{piece}: shadows reach over its upper edge at some time and are cut off</source>
        <translation>{piece}：影が上端を越える時があり、そこで切れます</translation>
    </message>
    <message>
        <source>{place}: {cause}</source>
        <translation>{place}：{cause}</translation>
    </message>
    <message>
        <source>{problem} ({lost})</source>
        <translation>{problem}（{lost}）</translation>
    </message>
    <message>
        <source>{reason}</source>
        <translation>{reason}</translation>
    </message>
    <message>
        <source>{style} came without its own {what}: light is for all characters, and only some are meant</source>
        <translation>{style}に含まれる{what}は使いませんでした。ライトは全キャラクター共通ですが、一部のキャラクターだけが対象です</translation>
    </message>
    <message>
        <source>{style} came without its own {what}: {asking} brings that too</source>
        <translation>{style}に含まれる{what}は使いませんでした。使うには：{asking}</translation>
    </message>
    <message>
        <source>{style}: 1 property changed</source>
        <translation>{style}：プロパティ 1 個を変更しました</translation>
    </message>
    <message>
        <source>{style}: nothing looks otherwise than before</source>
        <translation>{style}：見た目は前と変わりません</translation>
    </message>
    <message>
        <source>{style}: {count} properties changed</source>
        <translation>{style}：プロパティ {count} 個を変更しました</translation>
    </message>
    <message>
        <source>{text!r} cannot be named in a job: it has braces</source>
        <translation>{text!r} には波かっこがあるため、ジョブに書けません</translation>
    </message>
    <message>
        <source>{text!r} is not a number; type 12.5, *2, /3, +10, -=10 or 50%</source>
        <translation>{text!r} は数ではありません。12.5、*2、/3、+10、-=10、50% のように入力してください</translation>
    </message>
    <message>
        <source>{text!r} is not a size such as 1920x1080</source>
        <translation>{text!r} は 1920x1080 のようなサイズではありません</translation>
    </message>
    <message>
        <source>{text!r} is not one of {words}</source>
        <translation>{text!r} は使えません。次のどれかにしてください：{words}</translation>
    </message>
    <message>
        <source>{text!r} is not {what}</source>
        <translation>{text!r} は使えません（使えるのは {what}）</translation>
    </message>
    <message>
        <source>{typed!r} is not a frame; type 84, 3+12, 3:12 or +6</source>
        <translation>{typed!r} はフレームではありません。84、3+12、3:12、+6 のように入力してください</translation>
    </message>
    <message>
        <source>{typed!r} is not a number of frames a second such as 24 or 24000/1001</source>
        <translation>{typed!r} はフレームレートではありません（例：24、24000/1001）</translation>
    </message>
    <message>
        <source>{value} is not {wanted}</source>
        <translation>{value} は使えません（使えるのは {wanted}）</translation>
    </message>
    <message>
        <source>{variable}: {path}: {cause}</source>
        <translation>{variable}：{path}：{cause}</translation>
    </message>
    <message>
        <source>{wanted}, each within ±{most_coordinate_px:g}</source>
        <translation>{wanted}、それぞれ ±{most_coordinate_px:g} 以内</translation>
    </message>
    <message>
        <source>{width} × {height} px is larger than can be read</source>
        <translation>{width} × {height} px は大きすぎて読み込めません</translation>
    </message>
    <message>
        <source>{width} × {height} px need {needed} MB of memory to be read, of which {free} MB are free</source>
        <translation>{width} × {height} px の読み込みには {needed} MB のメモリーが必要ですが、空きは {free} MB です</translation>
    </message>
    <message>
        <source>{word!r} cannot stand on a slate: at most {most} printable characters</source>
        <translation>{word!r} は使えません。表示できる文字で {most} 文字までです</translation>
    </message>
    <message>
        <source>{word!r} is written as {which!r} of the timesheet, where some programs take digits alone, four at most</source>
        <translation>{word!r} をタイムシートの {which!r} に書きますが、最大 4 桁の数字しか受け付けないプログラムもあります</translation>
    </message>
    <message>
        <source>{words}</source>
        <translation>{words}</translation>
    </message>
    <message>
        <source>{workers} workers are not 1 to {most_workers}</source>
        <translation>ワーカー数 {workers} は 1～{most_workers} の範囲にありません</translation>
    </message>
    <message>
        <source>Steps</source>
        <comment>a set piece to walk up</comment>
        <translation>階段</translation>
    </message>
</context>
<context>
    <name>MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>閉じる</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>他 %n 件</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MissingParts</name>
    <message>
        <source>“Missing Parts” in the Help menu shows how</source>
        <translation>入れ方は［ヘルプ］の［足りない部品…］にあります</translation>
    </message>
    <message>
        <source>Missing Parts</source>
        <translation>足りない部品</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Nothing is missing: every part of the program is installed.</source>
        <translation>足りないものはありません。すべての部品が入っています。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>This installation lacks parts for:</source>
        <translation>次のことに必要な部品が入っていません：</translation>
    </message>
    <message>
        <source>They cost nothing and are added once:</source>
        <translation>無料で、追加は一度だけです：</translation>
    </message>
    <message>
        <source>1.  Copy this line.</source>
        <translation>1.  下の行をコピーします。</translation>
    </message>
    <message>
        <source>2.  Open a terminal (in Windows: PowerShell), paste it there and press Enter.</source>
        <translation>2.  ターミナル（Windows では PowerShell）を開き、貼り付けて Enter を押します。</translation>
    </message>
    <message>
        <source>3.  When it is done, close this window: the part is there at once.</source>
        <translation>3.  終わったらこのウィンドウを閉じます。すぐに使えます。</translation>
    </message>
</context>
<context>
    <name>NamingRows</name>
    <message>
        <source>File names</source>
        <translation>ファイル名</translation>
    </message>
    <message>
        <source>Folders and name of a file: {layer}, {kind}, {name}, {scene}, {cut} and, once, {frame}; {frame:04d} says its digits.</source>
        <translation>フォルダーとファイル名の書式：{layer}、{kind}、{name}、{scene}、{cut}、それに {frame} を 1 回。{frame:04d} のように桁数を書けます。</translation>
    </message>
    <message>
        <source>as in the cut (%1)</source>
        <translation>カットと同じ（%1）</translation>
    </message>
    <message>
        <source>Number of the first frame</source>
        <translation>先頭フレームの番号</translation>
    </message>
    <message>
        <source>The number in the file of the cut&apos;s first frame, such as 1001.</source>
        <translation>カットの先頭フレームのファイルに付く番号です。例：1001</translation>
    </message>
    <message>
        <source>First number</source>
        <translation>開始番号</translation>
    </message>
</context>
<context>
    <name>NoteList</name>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>追加…</translation>
    </message>
    <message>
        <source>Pin a note to this frame</source>
        <translation>このフレームにメモを付けます</translation>
    </message>
    <message>
        <source>Answer…</source>
        <translation>返信…</translation>
    </message>
    <message>
        <source>Say something to this note</source>
        <translation>このメモに返信します</translation>
    </message>
    <message>
        <source>More</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>編集…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>A note is pinned to a keyed property, and nothing is keyed yet.</source>
        <translation>メモはキーのあるプロパティに付けますが、まだキーがありません。</translation>
    </message>
    <message>
        <source>Note on frame %1, %2</source>
        <translation>フレーム %1、%2 のメモ</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>返信</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>メモを追加</translation>
    </message>
    <message>
        <source>Answer note</source>
        <translation>メモに返信</translation>
    </message>
    <message>
        <source>Tick note</source>
        <translation>メモの済みを変更</translation>
    </message>
    <message>
        <source>Change note</source>
        <translation>メモを変更</translation>
    </message>
    <message>
        <source>Delete note</source>
        <translation>メモを削除</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
</context>
<context>
    <name>Notes</name>
    <message>
        <source>There are no notes to export.</source>
        <translation>書き出すメモがありません。</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>テキスト</translation>
    </message>
    <message>
        <source>Export Notes</source>
        <translation>メモを書き出し</translation>
    </message>
    <message>
        <source>The notes are in %1</source>
        <translation>メモを %1 に書き出しました</translation>
    </message>
</context>
<context>
    <name>OpenProject</name>
    <message>
        <source>New from cels</source>
        <translation>セルから新規作成</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>保存していない作業を復元</translation>
    </message>
    <message>
        <source>Import character</source>
        <translation>キャラクターを読み込み</translation>
    </message>
    <message>
        <source>New from timesheet</source>
        <translation>タイムシートから新規作成</translation>
    </message>
    <message>
        <source>the work area</source>
        <translation>ワークエリア</translation>
    </message>
    <message>
        <source>Apply timesheet</source>
        <translation>タイムシートを適用</translation>
    </message>
    <message>
        <source>Set background</source>
        <translation>背景を設定</translation>
    </message>
</context>
<context>
    <name>OverflowRow</name>
    <message>
        <source>More tools</source>
        <translation>その他のツール</translation>
    </message>
</context>
<context>
    <name>PieceName</name>
    <message>
        <source>Set piece: %1</source>
        <translation>セット：%1</translation>
    </message>
</context>
<context>
    <name>PointsEditor</name>
    <message>
        <source>Double-click on the character in the picture to add a grounding point</source>
        <translation>画面のキャラクターをダブルクリックすると接地点を追加できます</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>クリア</translation>
    </message>
    <message numerus="yes">
        <source>%n point(s)</source>
        <translation>
            <numerusform>%n 点</numerusform>
        </translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
</context>
<context>
    <name>PreferencesDialog</name>
    <message>
        <source>Preferences</source>
        <translation>環境設定</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>システムに合わせる</translation>
    </message>
    <message>
        <source>Own colour…</source>
        <translation>カスタム…</translation>
    </message>
    <message>
        <source>a command, if any</source>
        <translation>コマンド（任意）</translation>
    </message>
    <message>
        <source>It runs when everything of an export is there, with a JSON file that says what was made.</source>
        <translation>書き出しがすべて終わると実行します。何を書き出したかを記した JSON ファイルを渡します。</translation>
    </message>
    <message>
        <source>Colour around the picture</source>
        <translation>画面の周囲の色</translation>
    </message>
    <message>
        <source>%1: there is no such folder</source>
        <translation>%1：このフォルダーはありません</translation>
    </message>
    <message>
        <source>Choose a Folder</source>
        <translation>フォルダーを選ぶ</translation>
    </message>
    <message>
        <source>The window speaks it when this dialog is closed.</source>
        <translation>このダイアログを閉じると切り替わります。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Preview resolution</source>
        <translation>プレビュー解像度</translation>
    </message>
    <message>
        <source>Around the picture</source>
        <translation>画面の周囲</translation>
    </message>
    <message>
        <source>of at most %1 MB on this machine</source>
        <translation>このマシンでの上限 %1 MB</translation>
    </message>
    <message>
        <source>Memory for drawings</source>
        <translation>セルに使うメモリー</translation>
    </message>
    <message>
        <source>Name under notes</source>
        <translation>メモに付く名前</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>未保存の作業</translation>
    </message>
    <message>
        <source>After an export</source>
        <translation>書き出しのあと</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>the folder last used</source>
        <translation>前回使ったフォルダー</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>参照…</translation>
    </message>
    <message>
        <source>Where unsaved work is put aside</source>
        <translation>未保存の作業の退避先</translation>
    </message>
    <message>
        <source>Unsaved work is put aside by itself while you work, and offered after a crash</source>
        <translation>未保存の作業は作業中に自動で退避され、異常終了後に復元できます</translation>
    </message>
    <message>
        <source>Show Folder</source>
        <translation>フォルダーを表示</translation>
    </message>
    <message>
        <source>Dark grey</source>
        <translation>暗いグレー</translation>
    </message>
    <message>
        <source>Middle grey</source>
        <translation>中間グレー</translation>
    </message>
    <message>
        <source>Light grey</source>
        <translation>明るいグレー</translation>
    </message>
    <message>
        <source>White</source>
        <translation>白</translation>
    </message>
    <message>
        <source>Projects begin in</source>
        <translation>プロジェクトの開始フォルダー</translation>
    </message>
    <message>
        <source>Cels begin in</source>
        <translation>セルの開始フォルダー</translation>
    </message>
    <message>
        <source>Backgrounds begin in</source>
        <translation>背景の開始フォルダー</translation>
    </message>
    <message>
        <source>Exports begin in</source>
        <translation>書き出しの開始フォルダー</translation>
    </message>
    <message>
        <source>Automatic: lower while dragging</source>
        <translation>自動（ドラッグ中は下げる）</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>フル</translation>
    </message>
    <message>
        <source>Half</source>
        <translation>1/2</translation>
    </message>
    <message>
        <source>Quarter</source>
        <translation>1/4</translation>
    </message>
</context>
<context>
    <name>PresetRow</name>
    <message>
        <source>Preset</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>名前を変更…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>None saved yet</source>
        <translation>保存されたプリセットはありません</translation>
    </message>
    <message>
        <source>Choices of your own</source>
        <translation>カスタム設定</translation>
    </message>
    <message>
        <source>%1 (studio)</source>
        <translation>%1（スタジオ）</translation>
    </message>
    <message>
        <source>Choose one of your presets first.</source>
        <translation>先にプリセットを選択してください。</translation>
    </message>
    <message>
        <source>Save as a Preset</source>
        <translation>プリセットとして保存</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Rename the Preset</source>
        <translation>プリセットの名前を変更</translation>
    </message>
</context>
<context>
    <name>ProjectActions</name>
    <message>
        <source>%1: neither a project, a folder of cels, a set nor a picture that can be read</source>
        <translation>%1：プロジェクト、セルのフォルダー、3Dセット、読める画像のいずれでもありません</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>名称未設定</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 を保存しました</translation>
    </message>
</context>
<context>
    <name>PropertyRow</name>
    <message>
        <source>Changed; double-click for the default, %1</source>
        <translation>変更済み。ダブルクリックでデフォルト（%1）に戻す</translation>
    </message>
</context>
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>Drive</source>
        <translation>ドライブ</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>%1 File</source>
        <translation>%1 ファイル</translation>
    </message>
    <message>
        <source>File Folder</source>
        <translation>ファイル フォルダー</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Alias</source>
        <translation>エイリアス</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>不明</translation>
    </message>
</context>
<context>
    <name>QColorDialog</name>
    <message>
        <source>Pick Screen Color</source>
        <translation>画面の色を選ぶ</translation>
    </message>
    <message>
        <source>&amp;Pick Screen Color</source>
        <translation>画面の色を選ぶ(&amp;P)</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>&amp;Look in:</source>
        <translation>場所(&amp;L):</translation>
    </message>
    <message>
        <source>Files of &amp;type:</source>
        <translation>ファイルの種類(&amp;T):</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>%1 KiB</source>
        <translation>%1 KB</translation>
    </message>
    <message>
        <source>%1 MiB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>%1 GiB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>%1 TiB</source>
        <translation>%1 TB</translation>
    </message>
</context>
<context>
    <name>Readout</name>
    <message>
        <source>%1 since key %2</source>
        <translation>キー %2 から %1</translation>
    </message>
    <message>
        <source>%1 against the snapshot</source>
        <translation>スナップショットとの差 %1</translation>
    </message>
</context>
<context>
    <name>RecoveryDialog</name>
    <message>
        <source>Recover Unsaved Work</source>
        <translation>保存していない作業の復元</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>復元</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Kagezou ended before this work was saved. It was put aside:</source>
        <translation>この作業が保存される前に Kagezou が終了しました。作業は退避してあります:</translation>
    </message>
    <message>
        <source>Show Folder</source>
        <translation>フォルダーを表示</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>後で</translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>未保存</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n 回の操作</numerusform>
        </translation>
    </message>
    <message>
        <source>The project was saved after this work began from it; nothing replaces it unasked.</source>
        <translation>この作業が始まった後にプロジェクトが保存されています。確認なしに置き換えることはありません。</translation>
    </message>
    <message>
        <source>Another window has recovered this work already.</source>
        <translation>この作業は、すでに別のウィンドウで復元されています。</translation>
    </message>
</context>
<context>
    <name>RetakeResult</name>
    <message>
        <source>Replaced Drawings: %1</source>
        <translation>差し替えたセル：%1</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>今</translation>
    </message>
    <message>
        <source>Known again by</source>
        <translation>見分け方</translation>
    </message>
    <message>
        <source>Go to the First Frame to Look At</source>
        <translation>確認する最初のフレームへ</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>name and picture</source>
        <translation>名前と画像</translation>
    </message>
    <message>
        <source>name; another picture</source>
        <translation>名前（画像は別）</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>likeness</source>
        <translation>似た画像</translation>
    </message>
    <message>
        <source>order</source>
        <translation>並び順</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新しい</translation>
    </message>
    <message>
        <source>gone</source>
        <translation>なくなった</translation>
    </message>
</context>
<context>
    <name>ReviewBar</name>
    <message>
        <source>Previous note or flag</source>
        <translation>前のメモまたは注意点</translation>
    </message>
    <message>
        <source>Next note or flag</source>
        <translation>次のメモまたは注意点</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>済み</translation>
    </message>
    <message>
        <source>Answer…</source>
        <translation>返信…</translation>
    </message>
    <message>
        <source>Add Note…</source>
        <translation>メモを追加…</translation>
    </message>
    <message>
        <source>Leave Review (Esc)</source>
        <translation>レビューを終了 (Esc)</translation>
    </message>
</context>
<context>
    <name>ReviewMode</name>
    <message>
        <source>There are no notes, and nothing stands out.</source>
        <translation>メモも、目立つところもありません。</translation>
    </message>
    <message>
        <source>This is the last one.</source>
        <translation>これが最後です。</translation>
    </message>
    <message>
        <source>This is the first one.</source>
        <translation>これが最初です。</translation>
    </message>
    <message>
        <source>Go to a note first.</source>
        <translation>先にメモへ移動してください。</translation>
    </message>
    <message>
        <source>Notes: %1, flags: %2</source>
        <translation>メモ：%1、注意点：%2</translation>
    </message>
</context>
<context>
    <name>RowMenu</name>
    <message>
        <source>Copy Value</source>
        <translation>値をコピー</translation>
    </message>
    <message>
        <source>Copy All of This Section</source>
        <translation>このセクションの値をすべてコピー</translation>
    </message>
    <message>
        <source>Reset to Default</source>
        <translation>デフォルトに戻す</translation>
    </message>
    <message>
        <source>Remove Key</source>
        <translation>キーを削除</translation>
    </message>
    <message>
        <source>Set Key</source>
        <translation>キーを設定</translation>
    </message>
    <message>
        <source>Remove All Keys</source>
        <translation>すべてのキーを削除</translation>
    </message>
    <message>
        <source>Give Each Character Its Own</source>
        <translation>キャラクターごとの値に戻す</translation>
    </message>
    <message>
        <source>Make the Same for All Characters</source>
        <translation>全キャラクターで共通にする</translation>
    </message>
    <message>
        <source>Copy Name for Scripts</source>
        <translation>スクリプト用の名前をコピー</translation>
    </message>
    <message>
        <source>Reset All of This Section</source>
        <translation>このセクションをすべてリセット</translation>
    </message>
    <message>
        <source>Reset section</source>
        <translation>セクションをリセット</translation>
    </message>
    <message>
        <source>Paste Value</source>
        <translation>値を貼り付け</translation>
    </message>
    <message>
        <source>Paste %1 Values</source>
        <translation>%1 個の値を貼り付け</translation>
    </message>
    <message>
        <source>Paste values</source>
        <translation>値を貼り付け</translation>
    </message>
</context>
<context>
    <name>RowNames</name>
    <message>
        <source>Layers and properties</source>
        <translation>レイヤーとプロパティ</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>シーン</translation>
    </message>
    <message>
        <source>Scene (light, ground)</source>
        <translation>シーン（ライト・地面）</translation>
    </message>
    <message>
        <source>%1 (set)</source>
        <translation>%1（セット）</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>足</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>キーを削除</translation>
    </message>
    <message>
        <source>Set key</source>
        <translation>キーを設定</translation>
    </message>
    <message>
        <source>Show or hide the properties (Alt: of all)</source>
        <translation>プロパティの表示/非表示（Alt：すべて）</translation>
    </message>
    <message>
        <source>Previous key of this row</source>
        <translation>この行の前のキー</translation>
    </message>
    <message>
        <source>Next key of this row</source>
        <translation>この行の次のキー</translation>
    </message>
    <message>
        <source>Set a key on this frame, or remove the one that is here</source>
        <translation>このフレームにキーを設定、または既にあるキーを削除</translation>
    </message>
    <message>
        <source>%1 missing files in</source>
        <comment>then a folder</comment>
        <translation>見つからないファイル %1 個：</translation>
    </message>
</context>
<context>
    <name>Ruler</name>
    <message>
        <source>Frame ruler</source>
        <translation>フレームルーラー</translation>
    </message>
    <message>
        <source>Clear work area</source>
        <translation>ワークエリアを解除</translation>
    </message>
    <message>
        <source>Move marker</source>
        <translation>マーカーを移動</translation>
    </message>
    <message>
        <source>Set work area</source>
        <translation>ワークエリアを設定</translation>
    </message>
</context>
<context>
    <name>Section</name>
    <message>
        <source>Less</source>
        <translation>少なく</translation>
    </message>
    <message>
        <source>More…</source>
        <translation>その他…</translation>
    </message>
</context>
<context>
    <name>SetBar</name>
    <message>
        <source>Stand On…</source>
        <translation>立つ場所…</translation>
    </message>
    <message>
        <source>Click the place of the set on which a character stands</source>
        <translation>キャラクターが立つセット上の場所をクリックします</translation>
    </message>
    <message>
        <source>Keep this view</source>
        <translation>今の見え方のまま</translation>
    </message>
    <message>
        <source>None in the file</source>
        <translation>ファイルにカメラなし</translation>
    </message>
    <message>
        <source>Click two points of the set, then say how long that is</source>
        <translation>セット上の2点をクリックし、その長さを入力します</translation>
    </message>
    <message>
        <source>The camera of the file settles the size</source>
        <translation>大きさはファイルのカメラで決まります</translation>
    </message>
    <message>
        <source>Size by Two Points…</source>
        <translation>2点で大きさを指定…</translation>
    </message>
    <message>
        <source>The camera of the file that the picture is seen with</source>
        <translation>画面に使うファイル内のカメラ</translation>
    </message>
    <message>
        <source>Which axis of the file points up</source>
        <translation>ファイルのどの軸が上を向くか</translation>
    </message>
    <message>
        <source>figure heights</source>
        <translation>キャラクターの身長</translation>
    </message>
    <message>
        <source>metres (a figure has 1.6)</source>
        <translation>メートル（身長 1.6 m）</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上方向</translation>
    </message>
    <message>
        <source>Between the two points there are</source>
        <translation>2点間の長さ</translation>
    </message>
    <message>
        <source>Set Size</source>
        <translation>大きさを決める</translation>
    </message>
</context>
<context>
    <name>SetCommands</name>
    <message>
        <source>Duplicate set piece</source>
        <translation>セットを複製</translation>
    </message>
    <message>
        <source>Remove set piece</source>
        <translation>セットを削除</translation>
    </message>
    <message>
        <source>Add wall</source>
        <translation>壁を追加</translation>
    </message>
    <message>
        <source>Add box</source>
        <translation>箱を追加</translation>
    </message>
    <message>
        <source>Add steps</source>
        <translation>階段を追加</translation>
    </message>
    <message>
        <source>Add ramp</source>
        <translation>スロープを追加</translation>
    </message>
    <message>
        <source>Add cylinder</source>
        <translation>円柱を追加</translation>
    </message>
    <message>
        <source>Add sphere</source>
        <translation>球を追加</translation>
    </message>
    <message>
        <source>Add set piece</source>
        <translation>セットを追加</translation>
    </message>
</context>
<context>
    <name>SetDelegate</name>
    <message>
        <source>Name of the set piece</source>
        <translation>セットの名前</translation>
    </message>
</context>
<context>
    <name>SetImports</name>
    <message>
        <source>There is no set from a file in this project</source>
        <translation>このプロジェクトにはファイルから読み込んだセットがありません</translation>
    </message>
    <message>
        <source>Import set</source>
        <translation>セットを読み込む</translation>
    </message>
    <message>
        <source>Settle set</source>
        <translation>セットを合わせる</translation>
    </message>
    <message>
        <source>Click where the character&apos;s feet are on the set. Esc ends it.</source>
        <translation>キャラクターの足元になるセット上の場所をクリックしてください。Esc で終了。</translation>
    </message>
    <message>
        <source>Click two points of the set whose distance you know. Esc ends it.</source>
        <translation>距離のわかるセット上の2点をクリックしてください。Esc で終了。</translation>
    </message>
    <message>
        <source>There is nothing of the set at that place; click another. Esc ends it.</source>
        <translation>そこにセットはありません。別の場所をクリックしてください。Esc で終了。</translation>
    </message>
    <message>
        <source>Stand on the set</source>
        <translation>セットに立たせる</translation>
    </message>
    <message>
        <source>Now the other point. Esc ends it.</source>
        <translation>もう1点をクリックしてください。Esc で終了。</translation>
    </message>
    <message>
        <source>Size of the set</source>
        <translation>セットの大きさ</translation>
    </message>
</context>
<context>
    <name>SetList</name>
    <message>
        <source>Set</source>
        <translation>セット</translation>
    </message>
    <message>
        <source>Add a wall, box or other set piece</source>
        <translation>壁・箱などのセットを追加</translation>
    </message>
    <message>
        <source>Duplicate set piece</source>
        <translation>セットを複製</translation>
    </message>
    <message>
        <source>Remove set piece</source>
        <translation>セットを削除</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前を変更</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隠す</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
</context>
<context>
    <name>SetModel</name>
    <message>
        <source>Show set piece</source>
        <translation>セットを表示</translation>
    </message>
    <message>
        <source>Hide set piece</source>
        <translation>セットを隠す</translation>
    </message>
    <message>
        <source>Rename set piece</source>
        <translation>セットの名前を変更</translation>
    </message>
</context>
<context>
    <name>SetView</name>
    <message>
        <source>Set pieces</source>
        <translation>セット一覧</translation>
    </message>
</context>
<context>
    <name>ShortcutEditor</name>
    <message>
        <source>Edit Keyboard Shortcuts</source>
        <translation>キーボードショートカットの編集</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>セット</translation>
    </message>
    <message>
        <source>%1 (studio)</source>
        <translation>%1（スタジオ）</translation>
    </message>
    <message>
        <source>Search by name or keys</source>
        <translation>名前またはキーで検索</translation>
    </message>
    <message>
        <source>Shortcuts of %1</source>
        <translation>%1 のショートカット</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>%1 に書き出しました</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Keys as in</source>
        <translation>キー配列</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>読み込み…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>書き出し…</translation>
    </message>
    <message>
        <source>Reset All</source>
        <translation>すべてリセット</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>変更あり</translation>
    </message>
    <message>
        <source>Import Shortcuts</source>
        <translation>ショートカットの読み込み</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>Export Shortcuts</source>
        <translation>ショートカットの書き出し</translation>
    </message>
</context>
<context>
    <name>ShortcutSheet</name>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>キーボードショートカット</translation>
    </message>
    <message>
        <source>With the hand</source>
        <translation>マウス・ペン操作</translation>
    </message>
    <message>
        <source>Search by name or keys</source>
        <translation>名前またはキーで検索</translation>
    </message>
    <message>
        <source>Nothing of this name</source>
        <translation>該当するものがありません</translation>
    </message>
    <message>
        <source>Set: %1</source>
        <translation>セット：%1</translation>
    </message>
    <message>
        <source>Edit Shortcuts…</source>
        <translation>ショートカットを編集…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>SizeRow</name>
    <message>
        <source>Usual size</source>
        <translation>定番のサイズ</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>カスタム</translation>
    </message>
</context>
<context>
    <name>Snapshot</name>
    <message>
        <source>Snapshot</source>
        <translation>スナップショット</translation>
    </message>
</context>
<context>
    <name>Status</name>
    <message>
        <source>How high the figure is over the ground on this frame</source>
        <translation>このフレームでキャラクターが地面からどれだけ離れているか</translation>
    </message>
    <message>
        <source>Size of the picture; a click opens the settings of the cut</source>
        <translation>画面サイズ（クリックでカット設定を開く）</translation>
    </message>
    <message>
        <source>Preview resolution; exports are always full</source>
        <translation>プレビューの解像度。書き出しは常にフルです</translation>
    </message>
    <message>
        <source>Look Only</source>
        <translation>閲覧のみ</translation>
    </message>
    <message>
        <source>Looking for feet: %1 of %2</source>
        <translation>足を探しています：%1 / %2</translation>
    </message>
    <message>
        <source>software rendering</source>
        <translation>ソフトウェア描画</translation>
    </message>
    <message>
        <source>Drag an edge to move the set piece, the arrows to size it, the lever at its front to turn it</source>
        <translation>線をドラッグでセットを移動、矢印で寸法、正面のレバーで回転</translation>
    </message>
    <message>
        <source>Drag the light to move the shadow; right-click a foot to say what it does, double-click to add one</source>
        <translation>ライトをドラッグして影を動かします。足を右クリックで接地を指定、ダブルクリックで足を追加</translation>
    </message>
    <message>
        <source>Drag the light to move the shadow; double-click on the character to add a grounding point</source>
        <translation>ライトをドラッグすると影が動きます。キャラクターをダブルクリックすると接地点を追加します</translation>
    </message>
</context>
<context>
    <name>StyleList</name>
    <message>
        <source>Style: %1</source>
        <translation>スタイル：%1</translation>
    </message>
    <message>
        <source>Styles</source>
        <translation>スタイル</translation>
    </message>
    <message>
        <source>The style %1 took the place of the one before</source>
        <translation>スタイル %1 を上書きしました</translation>
    </message>
    <message>
        <source>Has a light of its own</source>
        <translation>専用のライトがあります</translation>
    </message>
    <message>
        <source>Of the studio: %1</source>
        <translation>スタジオのもの：%1</translation>
    </message>
    <message>
        <source>%1 (studio)</source>
        <translation>%1（スタジオ）</translation>
    </message>
    <message>
        <source>With its light</source>
        <translation>ライトも使う</translation>
    </message>
    <message>
        <source>Where a style has a light of its own, take it along. Light is for all characters, so choose all.</source>
        <translation>スタイルにライトが含まれていれば、それも使います。ライトは全キャラクター共通なので、すべて選んでください。</translation>
    </message>
    <message>
        <source>Keep this look as a style of your own</source>
        <translation>この見た目を自分のスタイルとして保存</translation>
    </message>
    <message>
        <source>Remove your style</source>
        <translation>自分のスタイルを削除</translation>
    </message>
</context>
<context>
    <name>StyleName</name>
    <message>
        <source>Keep as a style</source>
        <translation>スタイルとして保存</translation>
    </message>
    <message>
        <source>Keep the light and the ground, too</source>
        <translation>ライトと地面も保存する</translation>
    </message>
    <message>
        <source>Light, ground, field of view and the look of the set&apos;s shadow, as they are on this canvas.</source>
        <translation>ライト、地面、視野角、セットの影の見た目を、このキャンバスでの値のまま保存します。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
</context>
<context>
    <name>StyleUse</name>
    <message>
        <source>“With its light” in the Styles panel</source>
        <translation>「スタイル」パネルの「ライトも使う」</translation>
    </message>
</context>
<context>
    <name>Swatch</name>
    <message>
        <source>Pick a colour</source>
        <translation>色を選択</translation>
    </message>
</context>
<context>
    <name>TakingDialog</name>
    <message>
        <source>Take from %1</source>
        <translation>%1 から取り込む</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>取り込む</translation>
    </message>
    <message>
        <source>Characters that get a look</source>
        <translation>見た目を取り込むキャラクター</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>キャラクター</translation>
    </message>
    <message>
        <source>Looks like</source>
        <translation>見た目の元</translation>
    </message>
    <message>
        <source>It is locked</source>
        <translation>ロックされています</translation>
    </message>
    <message>
        <source>What will change</source>
        <translation>変わること</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>ライト(&amp;L)</translation>
    </message>
    <message>
        <source>The light with its keys, and whether shadows unite</source>
        <translation>ライトとそのキー、影をひとつにまとめるか</translation>
    </message>
    <message>
        <source>L&amp;ooks</source>
        <translation>見た目(&amp;O)</translation>
    </message>
    <message>
        <source>The looks of the characters&apos; shadows</source>
        <translation>キャラクターの影の見た目</translation>
    </message>
    <message>
        <source>&amp;Ground</source>
        <translation>地面(&amp;G)</translation>
    </message>
    <message>
        <source>The ground with its keys, and the camera&apos;s field of view</source>
        <translation>地面とそのキー、カメラの画角</translation>
    </message>
    <message>
        <source>&amp;Set</source>
        <translation>セット(&amp;S)</translation>
    </message>
    <message>
        <source>The set pieces, in the place of those there are</source>
        <translation>セットの部品（今あるものと入れ替わります）</translation>
    </message>
    <message>
        <source>Take from project</source>
        <translation>プロジェクトから取り込む</translation>
    </message>
</context>
<context>
    <name>TargetList</name>
    <message>
        <source>What for</source>
        <translation>書き出し先</translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>Nothing is keyed yet: move the playhead and click the diamond before a property.</source>
        <translation>まだキーがありません。再生ヘッドを動かし、プロパティの左のひし形をクリックしてください。</translation>
    </message>
    <message>
        <source>Set marker</source>
        <translation>マーカーを設定</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>マーカー</translation>
    </message>
    <message>
        <source>What happens on frame %1:</source>
        <translation>フレーム %1 の内容:</translation>
    </message>
    <message>
        <source>Name marker</source>
        <translation>マーカーに名前を付ける</translation>
    </message>
    <message>
        <source>Rename Marker…</source>
        <translation>マーカーの名前を変更…</translation>
    </message>
    <message>
        <source>Remove Marker</source>
        <translation>マーカーを削除</translation>
    </message>
    <message>
        <source>Frames (84)</source>
        <translation>フレーム (84)</translation>
    </message>
    <message>
        <source>Seconds + frames (3+12)</source>
        <translation>秒＋コマ (3+12)</translation>
    </message>
    <message>
        <source>Sheet pages of 6 seconds</source>
        <translation>6秒シート</translation>
    </message>
    <message>
        <source>Sheet pages of 3 seconds</source>
        <translation>3秒シート</translation>
    </message>
    <message>
        <source>Timecode (00:03:12)</source>
        <translation>タイムコード (00:03:12)</translation>
    </message>
    <message>
        <source>Remove marker</source>
        <translation>マーカーを削除</translation>
    </message>
</context>
<context>
    <name>Transport</name>
    <message>
        <source>Frames a second</source>
        <translation>フレームレート</translation>
    </message>
    <message>
        <source>Frames a second; a click opens the settings of the cut</source>
        <translation>フレームレート（クリックでカット設定を開く）</translation>
    </message>
    <message>
        <source>(slow)</source>
        <translation>（遅れ）</translation>
    </message>
</context>
<context>
    <name>UnforeseenErrors</name>
    <message>
        <source>Something went wrong inside the program (%1). Save your project. Details: %2</source>
        <translation>プログラム内部で問題が起きました（%1）。プロジェクトを保存してください。詳細：%2</translation>
    </message>
    <message>
        <source>no log could be written</source>
        <translation>ログを書き込めませんでした</translation>
    </message>
</context>
<context>
    <name>Units</name>
    <message>
        <source>px/frame</source>
        <translation>px/コマ</translation>
    </message>
</context>
<context>
    <name>VelocityDialog</name>
    <message>
        <source>Key Velocity</source>
        <translation>キーの速度</translation>
    </message>
    <message>
        <source>%1 / frame</source>
        <translation>%1 / コマ</translation>
    </message>
    <message>
        <source>Incoming</source>
        <translation>入り</translation>
    </message>
    <message>
        <source>Outgoing</source>
        <translation>出</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Influence</source>
        <translation>影響</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
</context>
<context>
    <name>Viewport</name>
    <message>
        <source>Picture</source>
        <translation>画面</translation>
    </message>
</context>
<context>
    <name>WaveNote</name>
    <message>
        <source>Tear: 2π / length × the movement across the crests, added up over both sets; from 1 on it tears.</source>
        <translation>ちぎれ:2π / 波長 × 波の進む方向への動き（2組の合計）。1以上でちぎれます。</translation>
    </message>
    <message>
        <source>Loop over the cut</source>
        <translation>カットの長さでループ</translation>
    </message>
    <message>
        <source>Set both speeds to the nearest at which the last frame leads into the first</source>
        <translation>最後のコマが最初のコマにつながる、最も近い速さにします</translation>
    </message>
    <message>
        <source>No waves</source>
        <translation>波なし</translation>
    </message>
    <message>
        <source>Tear %1: the outline wobbles</source>
        <translation>ちぎれ値 %1：輪郭がゆれます</translation>
    </message>
    <message>
        <source>Tear %1: the outline is torn into stripes</source>
        <translation>ちぎれ値 %1：輪郭が縞にちぎれます</translation>
    </message>
    <message>
        <source>Loop waves</source>
        <translation>波をループ</translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>Recent projects</source>
        <translation>最近使ったプロジェクト</translation>
    </message>
    <message>
        <source>Cast shadows for drawn animation</source>
        <translation>手描きアニメーションのための落ち影</translation>
    </message>
    <message>
        <source>Drop a folder of cels here</source>
        <translation>セルのフォルダーをここにドロップ</translation>
    </message>
    <message>
        <source>New here? A guided first cut in five steps</source>
        <translation>はじめての方へ：五つの手順で最初のカット</translation>
    </message>
    <message>
        <source>Projects that you save or open are listed here.</source>
        <translation>保存または開いたプロジェクトがここに並びます。</translation>
    </message>
    <message>
        <source>Numbered images with transparency, one folder a character; or a .kage project</source>
        <translation>透明部分のある連番画像（キャラクターごとに1フォルダー）、または .kage プロジェクト</translation>
    </message>
    <message>
        <source>Choose cels…</source>
        <translation>セルを選択…</translation>
    </message>
    <message>
        <source>Open a project…</source>
        <translation>プロジェクトを開く…</translation>
    </message>
    <message>
        <source>Begin with a style</source>
        <translation>スタイルを選んで始める</translation>
    </message>
    <message>
        <source>The next character gets it; the Styles panel changes it at any time.</source>
        <translation>次に読み込むキャラクターに適用されます。スタイルパネルでいつでも変更できます。</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>デモを開く</translation>
    </message>
</context>
</TS>

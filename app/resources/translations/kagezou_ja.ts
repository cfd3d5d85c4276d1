<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>BoxHand</name>
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
        <source>time × %1</source>
        <translation>時間 × %1</translation>
    </message>
    <message>
        <source>value × %1</source>
        <translation>値 × %1</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 フレーム</translation>
    </message>
</context>
<context>
    <name>Choice</name>
    <message>
        <source>Lamp</source>
        <translation>ランプ</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>太陽</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>ソリッド</translation>
    </message>
    <message>
        <source>Translucent</source>
        <translation>半透明</translation>
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
        <source>On ones</source>
        <translation>1コマ打ち</translation>
    </message>
    <message>
        <source>With the drawings</source>
        <translation>絵に合わせる</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>箱</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>階段</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>坂</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>円柱</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>球</translation>
    </message>
    <message>
        <source>3-D set</source>
        <translation>3Dセット</translation>
    </message>
    <message>
        <source>Not at all</source>
        <translation>表示しない</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>ワイヤーフレーム</translation>
    </message>
    <message>
        <source>Clay</source>
        <translation>クレイ</translation>
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
        <source>&amp;Import Character…</source>
        <translation>キャラクターを読み込み(&amp;I)…</translation>
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
        <source>Edit &amp;Keyboard Shortcuts…</source>
        <translation>キーボードショートカットを編集 (&amp;K)…</translation>
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
        <translation>前の動画 (&amp;D)</translation>
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
        <translation>ワークエリアをメモリに読み込む(&amp;I)</translation>
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
        <source>&amp;Find Command…</source>
        <translation>コマンドを検索 (&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts</source>
        <translation>キーボードショートカット(&amp;K)</translation>
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
        <translation>キャラが立つ線に沿ってドラッグ  ·  Enter：地面はこのまま  ·  Esc：終了</translation>
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
        <source>Swap with snapshot</source>
        <translation>スナップショットと入れ替え</translation>
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
        <source>Look only: nothing can be changed here</source>
        <translation>閲覧のみ: ここでは変更できません</translation>
    </message>
    <message>
        <source>Look Only</source>
        <translation>閲覧のみ</translation>
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
    <name>DemoOpener</name>
    <message>
        <source>Drawing the demo: %1 of %2</source>
        <translation>デモを作画中：%1 / %2</translation>
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
    <name>Dialogs</name>
    <message>
        <source>Open Project</source>
        <translation>プロジェクトを開く</translation>
    </message>
    <message>
        <source>Projects, timesheets and PSD files</source>
        <translation>プロジェクト・タイムシート・PSD</translation>
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
        <source>Choose Cels</source>
        <translation>セルを選択</translation>
    </message>
    <message>
        <source>Choose a Background</source>
        <translation>背景を選択</translation>
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
        <source>Whoever saves last wins. It is open there: %1.</source>
        <translation>後から保存した内容が残ります。開いている場所: %1</translation>
    </message>
    <message>
        <source>Open Anyway</source>
        <translation>それでも開く</translation>
    </message>
    <message>
        <source>“%1” was changed outside this window. Save over it?</source>
        <translation>「%1」はこのウィンドウの外で変更されています。上書きしますか？</translation>
    </message>
    <message>
        <source>What was changed there is kept only as its backup copy (NAME~).</source>
        <translation>外での変更はバックアップ (名前~) としてのみ残ります。</translation>
    </message>
    <message>
        <source>Save Anyway</source>
        <translation>それでも保存</translation>
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
        <source>Kagezou projects</source>
        <translation>Kagezou プロジェクト</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>画像</translation>
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
    <name>DrawingHand</name>
    <message>
        <source>empty</source>
        <translation>空セル</translation>
    </message>
    <message>
        <source>%1: frames %2 to %3, held %4</source>
        <translation>%1：%2～%3 フレーム、%4 コマ</translation>
    </message>
    <message>
        <source>Drag an end to hold it longer or shorter (Shift: what follows moves along), the middle to move it</source>
        <translation>端をドラッグで長さを変更（Shift で後続も移動）、中央をドラッグで移動</translation>
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
        <translation>%1 をキャラの後ろに置く</translation>
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
        <source>Choose a folder.</source>
        <translation>フォルダーを選択してください。</translation>
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
        <translation>マット: 影のみ</translation>
    </message>
    <message>
        <source>Matte: the part near the feet</source>
        <translation>マット: 足元の部分</translation>
    </message>
    <message>
        <source>Matte: distance from the feet</source>
        <translation>マット: 足元からの距離</translation>
    </message>
    <message>
        <source>Matte: what no shadow lies on</source>
        <translation>マット: 影のない部分</translation>
    </message>
    <message>
        <source>Mattes: the ground and every set piece</source>
        <translation>マット：地面とセットのそれぞれ</translation>
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
        <source>An export is still running.</source>
        <translation>書き出しはまだ実行中です。</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>停止中</translation>
    </message>
    <message>
        <source>Exporting, %1 s left</source>
        <translation>書き出し中、残り %1 秒</translation>
    </message>
    <message numerus="yes">
        <source>Export stopped; %n file(s) are written and whole.</source>
        <translation>
            <numerusform>書き出しを中止しました。%n 個のファイルは完全に書き込まれています。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Exported %n file(s) to %1</source>
        <translation>
            <numerusform>%n 個のファイルを %1 に書き出しました</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FlagList</name>
    <message>
        <source>Flags</source>
        <translation>注意点</translation>
    </message>
    <message>
        <source>Jumps farther than, a frame:</source>
        <translation>1フレームでこれより大きく動いたら:</translation>
    </message>
    <message>
        <source>Nothing stands out.</source>
        <translation>目立つ点はありません。</translation>
    </message>
    <message>
        <source>jumps by %1 px</source>
        <translation>%1 px 跳んでいます</translation>
    </message>
    <message>
        <source>key between two drawings</source>
        <translation>動画の途中にあるキー</translation>
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
    <name>GraphHand</name>
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
    <name>Hand</name>
    <message>
        <source>Move %1</source>
        <translation>%1を移動</translation>
    </message>
    <message>
        <source>Nudge %1</source>
        <translation>%1を微調整</translation>
    </message>
    <message>
        <source>Add grounding point</source>
        <translation>接地点を追加</translation>
    </message>
    <message>
        <source>Remove grounding point</source>
        <translation>接地点を削除</translation>
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
        <translation>キャラクター作画のアルファから、2Dアニメーションの落ち影レイヤーを作ります。</translation>
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
        <translation>パネルの表示/非表示 (ハンドルや入力欄を操作していないとき)</translation>
    </message>
    <message>
        <source>Nudge the selected handle by 1 px, with Shift by 10 px</source>
        <translation>選択中のハンドルを 1 px (Shift で 10 px) 動かす</translation>
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
</context>
<context>
    <name>Incidents</name>
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
    <name>Inspector</name>
    <message>
        <source>Camera</source>
        <translation>カメラ</translation>
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
        <source>Waves</source>
        <translation>波</translation>
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
    <name>KeyHand</name>
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
        <source>Speed in</source>
        <translation>入り速度</translation>
    </message>
    <message>
        <source>Infl. in %</source>
        <translation>入り影響%</translation>
    </message>
    <message>
        <source>Speed out</source>
        <translation>出速度</translation>
    </message>
    <message>
        <source>Infl. out %</source>
        <translation>出影響%</translation>
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
        <translation>時間上のキーと動画</translation>
    </message>
</context>
<context>
    <name>Language</name>
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
        <source>Reorder layers</source>
        <translation>レイヤーの順序を変更</translation>
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
    <name>LinkButton</name>
    <message>
        <source>The same for all characters. Click to give each its own</source>
        <translation>全キャラで共通です。クリックするとキャラごとの値に戻ります</translation>
    </message>
    <message>
        <source>Click to make it the same for all characters, values and keys</source>
        <translation>クリックすると値もキーも全キャラで共通になります</translation>
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
        <translation>%1の絵を調べています</translation>
    </message>
    <message>
        <source>Measuring the figure of %1</source>
        <translation>%1の人物の位置を測っています</translation>
    </message>
    <message>
        <source>Finding a place for the lamp for %1</source>
        <translation>%1のランプの位置を探しています</translation>
    </message>
    <message>
        <source>Reading drawings of %1</source>
        <translation>%1の絵を読み込んでいます</translation>
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
        <source>F&amp;ile</source>
        <translation>ファイル(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
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
    <name>NoteList</name>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Add Note…</source>
        <translation>メモを追加…</translation>
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
        <source>Add note</source>
        <translation>メモを追加</translation>
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
    <name>PictureWidget</name>
    <message>
        <source>The graphics driver offers OpenGL %1; Kagezou needs 3.3. Update the driver.</source>
        <translation>グラフィックスドライバーは OpenGL %1 です。Kagezou には 3.3 が必要です。ドライバーを更新してください。</translation>
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
    <name>PieceSections</name>
    <message>
        <source>Place and size</source>
        <translation>位置と寸法</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>はたらき</translation>
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
        <translation>%1: プロジェクト、セルのフォルダー、3Dセット、読める画像のいずれでもありません</translation>
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
        <source>Reset %1</source>
        <translation>%1をリセット</translation>
    </message>
    <message>
        <source>Key %1</source>
        <translation>%1にキーを設定</translation>
    </message>
    <message>
        <source>Remove key of %1</source>
        <translation>%1のキーを削除</translation>
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
    <message>
        <source>Changed; double-click for the default, %1</source>
        <translation>変更済み。ダブルクリックでデフォルト（%1）に戻す</translation>
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
        <source>Kagezou did not end as it should. This work was put aside and never saved:</source>
        <translation>前回 Kagezou は正常に終了しませんでした。次の作業は保存されていませんが、控えが残っています:</translation>
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
        <translation>キャラごとの値に戻す</translation>
    </message>
    <message>
        <source>Make the Same for All Characters</source>
        <translation>全キャラで共通にする</translation>
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
        <source>Remove key</source>
        <translation>キーを削除</translation>
    </message>
    <message>
        <source>Set key</source>
        <translation>キーを設定</translation>
    </message>
    <message>
        <source>Show or hide the properties (Alt: of all)</source>
        <translation>プロパティの表示/非表示 (Alt: すべて)</translation>
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
    <name>SetBar</name>
    <message>
        <source>Stand On…</source>
        <translation>立つ場所…</translation>
    </message>
    <message>
        <source>Click the place of the set on which a character stands</source>
        <translation>キャラが立つセット上の場所をクリックします</translation>
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
        <translation>キャラの身長</translation>
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
        <translation>キャラの足元になるセット上の場所をクリックしてください。Esc で終了。</translation>
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
        <translation>セット: %1</translation>
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
    <name>Snapshot</name>
    <message>
        <source>Snapshot</source>
        <translation>スナップショット</translation>
    </message>
</context>
<context>
    <name>Status</name>
    <message>
        <source>Preview resolution; exports are always full</source>
        <translation>プレビューの解像度。書き出しは常にフルです</translation>
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
        <source>Drag the lamp to move the shadow; double-click on the character to add a grounding point</source>
        <translation>ランプをドラッグすると影が動きます。キャラクターをダブルクリックすると接地点を追加します</translation>
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
        <source>Keep this look as a style of your own</source>
        <translation>この見た目を自分のスタイルとして保存</translation>
    </message>
    <message>
        <source>Remove your style</source>
        <translation>自分のスタイルを削除</translation>
    </message>
    <message>
        <source>Keep as a style</source>
        <translation>スタイルとして保存</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
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
        <source>(slow)</source>
        <translation>（遅れ）</translation>
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
        <translation>%1 / フレーム</translation>
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
        <source>The tear number is 2π · amplitude / length, summed over both sets; the outline tears from 1 on.</source>
        <translation>ちぎれ値は 2π × 振幅 ÷ 波長（二つの波の合計）。1 以上で輪郭がちぎれます。</translation>
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
        <source>Begin with a look</source>
        <translation>見た目を選んで始める</translation>
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

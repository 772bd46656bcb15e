# Print an optspec for argparse to handle cmd's options that are independent of any subcommand.
function __fish_pinhole_global_optspecs
    string join \n lesson= renderer= h/help V/version
end

function __fish_pinhole_needs_command
    # Figure out if the current invocation already has a command.
    set -l cmd (commandline -opc)
    set -e cmd[1]
    argparse -s (__fish_pinhole_global_optspecs) -- $cmd 2>/dev/null
    or return
    if set -q argv[1]
        # Also print the command, so this can be used to figure out what it is.
        echo $argv[1]
        return 1
    end
    return 0
end

function __fish_pinhole_using_subcommand
    set -l cmd (__fish_pinhole_needs_command)
    test -z "$cmd"
    and return 1
    contains -- $cmd[1] $argv
end

complete -c pinhole -n "__fish_pinhole_needs_command" -l lesson -d 'The lesson to open: 7, or 7.3 for its third step, or a lesson file of your own' -r
complete -c pinhole -n "__fish_pinhole_needs_command" -l renderer -d 'How the window is drawn; by default, whichever works best' -r -f -a "wgpu\t'A graphics adapter, through wgpu'
cpu\t'Our own painter'"
complete -c pinhole -n "__fish_pinhole_needs_command" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c pinhole -n "__fish_pinhole_needs_command" -s V -l version -d 'Print version'
complete -c pinhole -n "__fish_pinhole_needs_command" -a "scenes" -d 'List the built-in scenes, a line each'
complete -c pinhole -n "__fish_pinhole_needs_command" -a "inspect" -d 'Show one ray: its camera, its numbers, and everything it hits'
complete -c pinhole -n "__fish_pinhole_needs_command" -a "render" -d 'Write the picture as PNG'
complete -c pinhole -n "__fish_pinhole_needs_command" -a "trace" -d 'Intersect the rays in a CSV file with a scene'
complete -c pinhole -n "__fish_pinhole_needs_command" -a "check" -d 'Grade a student\'s basis, rays, hits or picture, and name the mistake'
complete -c pinhole -n "__fish_pinhole_needs_command" -a "report" -d 'Measure the error of every method against its run time'
complete -c pinhole -n "__fish_pinhole_needs_command" -a "figure" -d 'Write a view, the derivation or two lines in the plane as a figure for slides'
complete -c pinhole -n "__fish_pinhole_needs_command" -a "export" -d 'Write the camera and the scene in another program\'s format'
complete -c pinhole -n "__fish_pinhole_needs_command" -a "share" -d 'Print a link to a scene or a lesson\'s step, or draw it as a QR code'
complete -c pinhole -n "__fish_pinhole_needs_command" -a "import" -d 'Read a camera from a glTF or from numbers, and write a scene file'
complete -c pinhole -n "__fish_pinhole_needs_command" -a "page" -d 'Write the program as a page for a browser, with a scene or a lesson in it'
complete -c pinhole -n "__fish_pinhole_needs_command" -a "completions" -d 'Print the script with which a shell completes commands, options and scenes'
complete -c pinhole -n "__fish_pinhole_using_subcommand scenes" -l json -d 'Print one JSON object'
complete -c pinhole -n "__fish_pinhole_using_subcommand scenes" -s h -l help -d 'Print help'
complete -c pinhole -n "__fish_pinhole_using_subcommand inspect" -l pixel -d 'The ray through a pixel\'s centre; rows and columns count from 0, row 0 on top' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand inspect" -l uv -d 'The ray through a point of the viewport, in world units from its centre' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand inspect" -l json -d 'Print one JSON object'
complete -c pinhole -n "__fish_pinhole_using_subcommand inspect" -s h -l help -d 'Print help'
complete -c pinhole -n "__fish_pinhole_using_subcommand render" -s o -l output -d 'The PNG file to write; - writes to standard output' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand render" -l width -d 'Columns; without --height, the rows follow from the ratio of the scene\'s image' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand render" -l height -d 'Rows; without --width, the columns follow from the ratio of the scene\'s image' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand render" -l view -d 'What the camera sees, or the scene with the camera in it' -r -f -a "camera\t''
world\t''"
complete -c pinhole -n "__fish_pinhole_using_subcommand render" -l shade -d 'The shading: how a hit becomes a colour' -r -f -a "lambert\t''
normal\t''
t\t''
object\t''"
complete -c pinhole -n "__fish_pinhole_using_subcommand render" -l aov -d 'Also write t, normal, u, v, object and certainty of every pixel as OpenEXR' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand render" -l overlay -d 'Draw the camera into the world view, or the image\'s marks over the camera view'
complete -c pinhole -n "__fish_pinhole_using_subcommand render" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c pinhole -n "__fish_pinhole_using_subcommand trace" -l rays -d 'The rays: header ox,oy,oz,dx,dy,dz, a row for each ray; - reads them from standard input' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand trace" -s o -l output -d 'Where to write object,t,px,py,pz,nx,ny,nz, a row for each ray; by default, standard output' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand trace" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c pinhole -n "__fish_pinhole_using_subcommand check" -l answers -d 'The answers, whose header says what they are; - reads them from standard input' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand check" -l codes -d 'Count the mistakes of a class instead, in codes of answers to exercises; - reads standard input' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand check" -l kind -d 'The kind of answers that is asked for; answers of another kind are an error' -r -f -a "basis\t''
rays\t''
hits\t''
picture\t''"
complete -c pinhole -n "__fish_pinhole_using_subcommand check" -l columns -d 'Columns that must be there, such as t,object; answers without them are an error' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand check" -l tolerance -d 'Maximum error of an answer relative to its size, by default 0.00001; for a picture, in levels of 255 per channel, by default 2' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand check" -l count-from -d 'The first number of rows and columns in the answers' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand check" -l map -d 'Write a map of the image: right answers light, wrong ones orange, not judged ones blue, the rest grey' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand check" -l complete -d 'Require every pixel: a pixel without an answer counts as wrong'
complete -c pinhole -n "__fish_pinhole_using_subcommand check" -l json -d 'Print one JSON object'
complete -c pinhole -n "__fish_pinhole_using_subcommand check" -l csv -d 'Print a table as CSV, a row for each file of a folder'
complete -c pinhole -n "__fish_pinhole_using_subcommand check" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c pinhole -n "__fish_pinhole_using_subcommand report" -l json -d 'Write one JSON object; without a path, to standard output in place of the table' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand report" -l plot -d 'Draw error against run time, a page for each scene; the ending chooses the format. For several scenes, and for the families, OUT.svg is a summary, and the pages are OUT-2.svg, OUT-3.svg and so on' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand report" -l seed -d 'Seed of the random rays in the stress families' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand report" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c pinhole -n "__fish_pinhole_using_subcommand figure" -l view -d 'What is drawn: the scene with the camera in it, what the camera sees, the derivation of every number, or two lines in the plane, which are the same for every scene' -r -f -a "world\t''
camera\t''
derivation\t''
lines\t''"
complete -c pinhole -n "__fish_pinhole_using_subcommand figure" -s o -l output -d 'The file to write; the ending chooses the format, and - writes SVG to standard output' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand figure" -l width -d 'Columns, in pixels; without --height, the rows follow in proportion' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand figure" -l height -d 'Rows, in pixels; without --width, the columns follow in proportion' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand figure" -l theme -d 'Dark on light, light on dark, or one of the window\'s colour schemes on either' -r -f -a "light\t''
dark\t''
colour-blind\t''
colour-blind-dark\t''
grey\t''
grey-dark\t''"
complete -c pinhole -n "__fish_pinhole_using_subcommand figure" -l pixel -d 'The ray through a pixel\'s centre; rows and columns count from 0, row 0 on top' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand figure" -l uv -d 'The ray through a point of the viewport, in world units from its centre' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand figure" -l transparent -d 'Leave the background out: in the views, whatever lies behind all objects'
complete -c pinhole -n "__fish_pinhole_using_subcommand figure" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c pinhole -n "__fish_pinhole_using_subcommand export" -l to -d 'The other program, form or language' -r -f -a "gltf\t'glTF 2.0; its camera\'s x, y, z are u, v, w'
three\t'three.js; its camera\'s x, y, z are u, v, w'
mitsuba\t'Mitsuba 3; its camera\'s x, y, z are −u, v, −w'
povray\t'POV-Ray; its camera\'s x, y, z are u, v, −w'
blender\t'Blender Python; its camera\'s x, y, z are u, v, w'
weekend\t'Ray Tracing in One Weekend; its camera\'s x, y, z are u, v, w'
opengl\t'gluLookAt + gluPerspective; its camera\'s x, y, z are u, v, w'
course\t'PerspectiveCamera of the course; its camera\'s x, y, z are u, v, w'
opencv\t'OpenCV K [R|t]; its camera\'s x, y, z are u, −v, −w'
pbrt\t'pbrt-v4; its camera\'s x, y, z are u, v, −w'
julia\t'Julia'
numpy\t'Python + NumPy'
glm\t'C++ (GLM)'
glsl\t'GLSL'
glam\t'Rust (glam)'
javascript\t'JavaScript'"
complete -c pinhole -n "__fish_pinhole_using_subcommand export" -s o -l output -d 'Where to write it; by default, standard output' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand export" -l camera-only -d 'Leave the objects out'
complete -c pinhole -n "__fish_pinhole_using_subcommand export" -l meshes -d 'Write objects as meshes where the format has nothing else: glTF'
complete -c pinhole -n "__fish_pinhole_using_subcommand export" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c pinhole -n "__fish_pinhole_using_subcommand share" -l lesson -d 'Share a lesson instead: 7, or 7.3 for its third step' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand share" -l step -d 'The lesson\'s step' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand share" -l pixel -d 'The ray through a pixel\'s centre; rows and columns count from 0, row 0 on top' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand share" -l uv -d 'The ray through a point of the viewport, in world units from its centre' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand share" -l base -d 'The address of the page, with https://' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand share" -s o -l output -d 'Draw the link as a QR code; the ending chooses the format, and - writes SVG to standard output' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand share" -l qr -d 'Draw the QR code in the terminal, and print the link below it'
complete -c pinhole -n "__fish_pinhole_using_subcommand share" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c pinhole -n "__fish_pinhole_using_subcommand import" -s o -l output -d 'The scene file to write; by default, standard output' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand import" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c pinhole -n "__fish_pinhole_using_subcommand page" -l lesson -d 'The lesson to open: 7, or 7.3 for its third step, or a lesson file of your own' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand page" -l step -d 'The lesson\'s step to open' -r
complete -c pinhole -n "__fish_pinhole_using_subcommand page" -s o -l output -d 'The page to write; - writes to standard output' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand page" -l page -d 'The page of the program itself; by default, pinhole.html beside the program' -r -F
complete -c pinhole -n "__fish_pinhole_using_subcommand page" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c pinhole -n "__fish_pinhole_using_subcommand completions" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c pinhole -n "__fish_pinhole_using_subcommand inspect" -a "canonical distance-two moved-eye forty-five look-at roll almost-parallel-up planet grazing tiny-far inside non-square" -d 'Built-in scene'
complete -c pinhole -n "__fish_pinhole_using_subcommand render" -a "canonical distance-two moved-eye forty-five look-at roll almost-parallel-up planet grazing tiny-far inside non-square" -d 'Built-in scene'
complete -c pinhole -n "__fish_pinhole_using_subcommand trace" -a "canonical distance-two moved-eye forty-five look-at roll almost-parallel-up planet grazing tiny-far inside non-square" -d 'Built-in scene'
complete -c pinhole -n "__fish_pinhole_using_subcommand check" -a "canonical distance-two moved-eye forty-five look-at roll almost-parallel-up planet grazing tiny-far inside non-square" -d 'Built-in scene'
complete -c pinhole -n "__fish_pinhole_using_subcommand report" -a "canonical distance-two moved-eye forty-five look-at roll almost-parallel-up planet grazing tiny-far inside non-square" -d 'Built-in scene'
complete -c pinhole -n "__fish_pinhole_using_subcommand figure" -a "canonical distance-two moved-eye forty-five look-at roll almost-parallel-up planet grazing tiny-far inside non-square" -d 'Built-in scene'
complete -c pinhole -n "__fish_pinhole_using_subcommand export" -a "canonical distance-two moved-eye forty-five look-at roll almost-parallel-up planet grazing tiny-far inside non-square" -d 'Built-in scene'
complete -c pinhole -n "__fish_pinhole_using_subcommand share" -a "canonical distance-two moved-eye forty-five look-at roll almost-parallel-up planet grazing tiny-far inside non-square" -d 'Built-in scene'
complete -c pinhole -n "__fish_pinhole_using_subcommand page" -a "canonical distance-two moved-eye forty-five look-at roll almost-parallel-up planet grazing tiny-far inside non-square" -d 'Built-in scene'
complete -c pinhole -n "__fish_pinhole_needs_command" -a "canonical distance-two moved-eye forty-five look-at roll almost-parallel-up planet grazing tiny-far inside non-square" -d 'Built-in scene'

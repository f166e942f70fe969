use shaderlint::cli::document::*; use shaderlint::lint::*; use shaderlint::rules::RULES; use shaderlint::diagnostic::*;
fn main(){
    let a: Vec<String> = std::env::args().collect();
    let settings = Settings::new(RULES,&["tidy".into(),"webgl2".into()],&[]).unwrap();
    let dir=&a[1];
    let mut n=[0usize;2];
    for e in std::fs::read_dir(dir).unwrap(){
        let p=e.unwrap().path(); if p.extension().is_none_or(|e|e!="glsl"){continue}
        let name=p.to_str().unwrap().to_string(); let t=std::fs::read_to_string(&p).unwrap();
        for (i,(al,x)) in [(Allow::Safe,"safe"),(Allow::Unsafe,"unsafe")].into_iter().enumerate(){
            let f=fix_text(&name,&t,DialectChoice::Auto,&settings,al);
            n[i]+=f.applied;
            let c=check(&name,shaderlint::cli::input::Content::utf8(&f.text[..]),DialectChoice::Auto,&settings).ok().unwrap();
            let er=c.diagnostics.iter().filter(|d|d.severity==Severity::Error).count();
            let left=c.diagnostics.iter().filter(|d|d.fix.as_ref().is_some_and(|f|al.permits(f))).count();
            if er>0||left>0{println!("{name} {x} errors {er} left {left} applied {}",f.applied)}
            std::fs::write(p.with_extension(x),f.text).unwrap();
        }
    }
    println!("{n:?}");
}
